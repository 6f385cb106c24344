import type { Pose, Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import { isLowThing, ownHeightOf } from '#scene/kinds/heights';
import type { SceneObject } from '#scene/scene';

import { kindOf } from './kinds/index';

/** The height of a thing as the picture says it. */
export interface HeightLabel {
  readonly id: string;
  readonly heightMm: number;
  /** The middle of the thing, world mm. */
  readonly atMm: Vec;
  /** From there to its lower and its upper side, so far apart as they are on the page: the words stand beyond. Of a wall 0. */
  readonly halfMm: number;
}

/** The heights that low things of a course say. @param poses of those that have moved, by their ids */
export const heightLabels = (
  objects: readonly SceneObject[],
  poses: Readonly<Record<string, Pose>>,
): readonly HeightLabel[] =>
  objects.filter(isLowThing).flatMap((object): HeightLabel[] => {
    const frame = kindOf(object).frame(object);
    const heightMm = ownHeightOf(object);
    if (frame === null || heightMm === null) return [];
    const { id } = object;
    if (object.type === 'wall') return [{ id, heightMm, atMm: frame.at, halfMm: 0 }];
    const {
      xMm: x,
      yMm: y,
      headingRad,
    } = poses[id] ?? { xMm: frame.at.x, yMm: frame.at.y, headingRad: frame.angleRad };
    const halfMm = (Math.abs(exactSin(headingRad)) * frame.size.x + Math.abs(exactCos(headingRad)) * frame.size.y) / 2;
    return [{ id, heightMm, atMm: { x, y }, halfMm }];
  });
