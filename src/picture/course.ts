import type { SceneObject } from '#scene/scene';

import type { CourseColors } from './colors';
import { kindOf } from './kinds/index';
import { jointShapes } from './kinds/wall';
import type { Look } from './look';
import type { Shape } from './shapes';

/** The objects of a course as shapes in the order of painting: what lies on the floor, signs and words over the lines, what stands. */
export const courseShapes = (objects: readonly SceneObject[], look: Look): readonly Shape[] => [
  ...objects.flatMap((object) => kindOf(object).ground?.(object, look) ?? []),
  ...objects.flatMap((object) => kindOf(object).line?.(object, look) ?? []),
  ...objects.flatMap((object) => kindOf(object).sign?.(object, look) ?? []),
  ...objects.flatMap((object) => kindOf(object).mark?.(object, look, objects) ?? []),
  ...jointShapes(objects, look),
  ...objects.flatMap((object) => kindOf(object).body?.(object, look) ?? []),
];

/** The floor of a course, as it is printed true to scale for the real robot; in full, however small. */
export function paperShapes(objects: readonly SceneObject[], colors: CourseColors): readonly Shape[] {
  const look: Look = { colors, px: 0, seconds: String };
  const layer = (object: SceneObject): number => (kindOf(object).ground ? 0 : kindOf(object).line ? 1 : 2);
  return [0, 1, 2].flatMap((wanted) =>
    objects.flatMap((object) => (layer(object) === wanted ? (kindOf(object).paper?.(object, look) ?? []) : [])),
  );
}
