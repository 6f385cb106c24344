import { degOf } from '#core/angle';
import { exactAtan2 } from '#core/exact-math';
import { lengthOf } from '#scene/outline';
import type { Point, SceneObject, Wall } from '#scene/scene';

import type { PaintColor } from '#scene/paint/paint';
import type { Look } from '../look';
import { paints } from '../paints';
import { circle, group, type Geometry, type Shape } from '../shapes';
import type { Frame, PictureKind } from './kind';

/** Walls, of bricks. */
export const wall: PictureKind<Wall> = {
  body: (wall, look) => [inWallFrame(wall, bricks(wall, look))],
  shade: (wall, fill) => inWallFrame(wall, [{ ...wallShape(wall, 0), fill }]),
  frame: wallFrame,
};

type Ends = Pick<Wall, 'from' | 'to' | 'thickness'>;

/** The turned rectangle around a wall. */
export function wallFrame({ from, to, thickness }: Ends): Frame {
  return {
    at: { x: (from[0] + to[0]) / 2, y: (from[1] + to[1]) / 2 },
    angleRad: exactAtan2(to[1] - from[1], to[0] - from[0]),
    size: { x: lengthOf(to[0] - from[0], to[1] - from[1]), y: thickness },
  };
}

/** Height of a course of bricks, in mm, about: a wall has at least two, and one beyond 60 mm has higher ones. */
const COURSE_MM = 5;

/** Ratio of a brick's length to its height. */
const BRICK = 3.4;

/** Shapes in a frame that starts at a wall's one end and runs along it. */
export const inWallFrame = ({ from, to }: Ends, inside: readonly Shape[]): Shape =>
  group(from, inside, degOf(exactAtan2(to[1] - from[1], to[0] - from[0])));

/** The outline of a wall in its frame. */
export const wallShape = ({ from, to, thickness }: Ends, round: number): Geometry => ({
  ...{ form: 'rect', at: [0, -thickness / 2], round },
  size: [lengthOf(to[0] - from[0], to[1] - from[1]), thickness],
});

const paintedBricks = (color: PaintColor) => {
  const { fill, ink } = paints[color];
  return { wall: fill, wallLight: fill, wallInk: ink };
};

function bricks(wall: Wall, look: Look): readonly Shape[] {
  const { px, leastLineMm = 0 } = look;
  const colors = wall.color === undefined ? look.colors : paintedBricks(wall.color);
  const thickness = Math.max(wall.thickness, leastLineMm);
  const outline = wallShape({ ...wall, thickness }, Math.min(1.6, thickness / 4));
  const body: Shape = { ...outline, fill: colors.wall };
  const courses = Math.max(2, Math.round(thickness / COURSE_MM / Math.max(1, thickness / 60)));
  const height = thickness / courses;
  if (height < 2.4 * px || outline.form !== 'rect') return [body];
  const [length] = outline.size;
  const joints: (readonly Point[])[] = [];
  const light: (readonly Point[])[] = [];
  for (let course = 0; course < courses; course += 1) {
    const [top, bottom] = [course * height - thickness / 2, (course + 1) * height - thickness / 2];
    if (course > 0) joints.push([[0, top], [length, top]]); // prettier-ignore
    const start = course % 2 === 0 ? 0 : -height * BRICK / 2; // prettier-ignore
    for (let i = 0; start + i * height * BRICK < length; i += 1) {
      const x = start + i * height * BRICK;
      if (x > 0) joints.push([[x, top], [x, bottom]]); // prettier-ignore
      const [left, right] = [Math.max(0, x), Math.min(length, x + height * BRICK)];
      if (isLight(course, i)) light.push([[left, top], [right, top], [right, bottom], [left, bottom]]); // prettier-ignore
    }
  }
  return [
    body,
    { form: 'lines', lines: light, isClosed: true, fill: colors.wallLight },
    { form: 'lines', lines: joints, stroke: colors.wallInk, width: Math.max(0.16 * height, 0.7 * px) },
  ];
}

/** About every third brick is lighter: scattered without a visible pattern, and the same at every zoom. */
function isLight(course: number, brick: number): boolean {
  const mixed = Math.imul(course * 374_761 + brick * 668_265 + 1_442_695, 0x9e3779b1);
  return ((mixed ^ (mixed >>> 15)) >>> 0) % 3 === 0;
}

/** A place where ends of walls meet. */
export interface WallJoint {
  readonly at: Point;
  /** Thickness of the thinnest wall there, mm. */
  readonly thickness: number;
}

/** The places where ends of walls meet: a disc there closes the notch that their straight ends leave. */
export function wallJoints(walls: readonly Wall[]): readonly WallJoint[] {
  const ends = new Map<string, { at: Point; thickness: number; count: number }>();
  for (const { from, to, thickness } of walls)
    for (const at of [from, to]) {
      const key = at.join();
      const there = ends.get(key) ?? { at, thickness, count: 0 };
      there.count += 1;
      there.thickness = Math.min(there.thickness, thickness);
      ends.set(key, there);
    }
  return [...ends.values()].filter(({ count }) => count > 1);
}

/** The discs where walls meet; to be put under the walls. */
export const jointShapes = (objects: readonly SceneObject[], { colors, leastLineMm = 0 }: Look): readonly Shape[] =>
  wallJoints(objects.filter((object) => object.type === 'wall')).map(({ at, thickness }) =>
    circle(Math.max(thickness, leastLineMm) / 2, { fill: colors.wall }, at),
  );
