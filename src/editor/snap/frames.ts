import type { Vec } from '#core/geometry';
import { boundsOf, solidParts } from '#scene/kinds/index';
import { boundsOfOutline, type Bounds, type Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { boundsAll } from '../bounds';
import { kindOf } from '../kinds/index';
import { rootOf } from '../moves';
import { plus, toVec } from '../plane';

/** The two directions in which things snap. */
export type Axis = 'x' | 'y';

/** Both, each of them with the other. */
export const axes = [
  ['x', 'y'],
  ['y', 'x'],
] as const satisfies readonly (readonly [Axis, Axis])[];

/** From where to where a thing lies along one axis, and its middle, in mm. */
export interface Span {
  readonly min: number;
  readonly mid: number;
  readonly max: number;
}

/** The edges and the middle of a thing, which snap and are snapped to. World mm. */
export type Frame = Readonly<Record<Axis, Span>>;

const spanOf = (min: number, max: number, mid = (min + max) / 2): Span => ({ min, mid, max });

/** The frame of an upright rectangle. */
export const frameOfBounds = ({ minX, minY, maxX, maxY }: Bounds): Frame => ({
  x: spanOf(minX, maxX),
  y: spanOf(minY, maxY),
});

/** The ends of a line; `null` for anything but a line. */
export function endsOf(object: SceneObject): readonly [Vec, Vec] | null {
  const kind = kindOf(object);
  const along = kind.span(object);
  if (along === null) return null;
  const from = toVec(kind.place(object));
  return [from, plus(from, along)];
}

const known = new WeakMap<SceneObject, Frame>();

/** The frame of an object: of what moves by itself, where it starts; of a line, its ends where it runs along the axis. */
export function frameOf(object: SceneObject): Frame {
  const { root, by } = rootOf(object);
  if (root !== object) return shiftedFrame(frameOf(root), by);
  const before = known.get(object);
  if (before) return before;
  const solid = solidParts(object).flat();
  const around = solid.length === 0 ? boundsOf(object) : boundsOfOutline(solid);
  const ends = endsOf(object);
  const whole = frameOfBounds(around);
  const frame = ends === null ? whole : alongLine(whole, frameOfBounds(boundsOfOutline(ends)));
  known.set(object, frame);
  return frame;
}

/** Across a line its width counts, along it its ends. */
function alongLine(whole: Frame, ends: Frame): Frame {
  const of = (axis: Axis): Span => (2 * lengthOf(ends[axis]) > lengthOf(whole[axis]) ? ends[axis] : whole[axis]);
  return { x: of('x'), y: of('y') };
}

/** How long a thing is along an axis. */
export const lengthOf = ({ min, max }: Span): number => max - min;

/** The frame of the robot at its start, with `at` (the middle of its axle) as its middle; `null`: no robot. */
export function frameOfRobot({ robot }: Scene, footprint: readonly Outline[]): Frame | null {
  const around = boundsAll(robotOutlines(robot, footprint).map(boundsOfOutline));
  if (around === null) return null;
  const { minX, maxX, minY, maxY } = around;
  return { x: spanOf(minX, maxX, robot.at[0]), y: spanOf(minY, maxY, robot.at[1]) };
}

/** The frame around several; of one its own. `null` for none. */
export function frameAround(frames: readonly Frame[]): Frame | null {
  const [first] = frames;
  if (first === undefined || frames.length === 1) return first ?? null;
  const of = (axis: Axis): Span =>
    spanOf(Math.min(...frames.map((one) => one[axis].min)), Math.max(...frames.map((one) => one[axis].max)));
  return { x: of('x'), y: of('y') };
}

/** A frame moved. */
export function shiftedFrame({ x, y }: Frame, by: Vec): Frame {
  const moved = ({ min, mid, max }: Span, mm: number): Span => ({ min: min + mm, mid: mid + mm, max: max + mm });
  return { x: moved(x, by.x), y: moved(y, by.y) };
}

/** The frame of a place. */
export const frameAt = ({ x, y }: Vec): Frame => ({ x: spanOf(x, x), y: spanOf(y, y) });

/** The frame of an arena. */
export const frameOfArena = ([width, height]: Point): Frame => ({ x: spanOf(0, width), y: spanOf(0, height) });
