import type { SceneObject, Wall } from '#scene/scene';

import { wallJoints } from '../../../pupil/arena/picture/kinds/wall';
import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { element, pathThrough } from './svg-write';
import type { PrintKind, ToPicture } from './kind';
import { degrees, turned } from './svg-parts';

/** Walls, of bricks. */
export const wall: PrintKind<Wall> = { layer: 3, svg: wallSvg };

function wallSvg({ from, to: end, thickness }: Wall, to: ToPicture): string {
  const [x, y] = to(from);
  const [dx, dy] = [end[0] - from[0], end[1] - from[1]];
  const length = Math.hypot(dx, dy);
  const courses = Math.max(2, Math.min(4, Math.round(thickness / 5)));
  const height = thickness / courses;
  const brick = height * 3.4;
  const lines: string[] = [];
  for (let course = 0; course < courses; course += 1) {
    const top = -thickness / 2 + course * height;
    if (course > 0) lines.push(pathThrough([[0, top], [length, top]])); // prettier-ignore
    // Of a very long wall the first bricks are enough to see what it is made of.
    for (let i = 1; i < 400; i += 1) {
      const at = (i - (course % 2) / 2) * brick;
      if (at >= length) break;
      lines.push(pathThrough([[at, top], [at, top + height]])); // prettier-ignore
    }
  }
  return element(
    'g',
    { transform: turned([x, y], -degrees(Math.atan2(dy, dx))) },
    element('rect', { y: -thickness / 2, width: length, height: thickness, rx: 1, fill: colors.wall }),
    element('path', { d: lines.join(''), fill: 'none', stroke: colors.wallInk, 'stroke-width': height * 0.16 }),
  );
}

/** Closes the notches where walls meet; to be put under them. */
export const jointsSvg = (objects: readonly SceneObject[], to: ToPicture): string =>
  wallJoints(objects.filter((object): object is Wall => object.type === 'wall'))
    .map(({ at, thickness }) => {
      const [cx, cy] = to(at);
      return element('circle', { cx, cy, r: thickness / 2, fill: colors.wall });
    })
    .join('');
