import type { Pose, Vec } from '#core/geometry';
import type { Stop } from '#core/stop';

/** Size of the arena in mm; a solid wall runs around its edge. */
export interface WorldSize {
  readonly widthMm: number;
  readonly heightMm: number;
}

/** A solid that `Chassis.touching` can name. */
interface Named {
  /** Its name, usually the id of the course's object. */
  readonly id?: string;
}

/** Shares of red, green and blue light that something returns, each 1 for bare floor. */
export type Shares = readonly [red: number, green: number, blue: number];

/** A solid that stands on the floor. */
interface Tall {
  /** Its top above the floor, for sensors; bodies collide at any height. Left out: endlessly high. */
  readonly heightMm?: number;
  /** Its colour, for colour sensors; left out: it has none. */
  readonly shares?: Shares;
}

/** A straight wall: a box along the line from one point to the other, as long as that line. */
export interface WallShape extends Named, Tall {
  readonly fromMm: Vec;
  readonly toMm: Vec;
  readonly thicknessMm: number;
}

/** The shape of a block or a mover from above: a rectangle, an ellipse, or convex parts. */
export interface BodyForm extends Tall {
  /** Length along its own x and y. */
  readonly sizeMm: Vec;
  /** True for the ellipse within `sizeMm`, a circle where both sides are equal. */
  readonly isRound?: boolean;
  /** Convex parts about its middle, counter-clockwise, which fill `sizeMm`; at least one. */
  readonly partsMm?: readonly (readonly Vec[])[];
}

/** A block, movable or fixed. */
export interface BlockShape extends Named, BodyForm {
  /** Its middle. */
  readonly atMm: Vec;
  readonly angleRad: number;
  readonly fixed: boolean;
  /** Left out: by its area, like beech. */
  readonly massG?: number;
  /** Ratio of the floor's friction to its weight; left out: that of wood, or of a ball that rolls. */
  readonly friction?: number;
  /** True for a ball, which rolls on and jumps back from what it hits. */
  readonly rolls?: boolean;
}

/** A barrier in the world. */
export interface BarrierHandle {
  /** True while it is no obstacle. */
  readonly isOpen: boolean;
  /** Opens it at once, or closes it as soon as nothing that moves stands in it. */
  set(isOpen: boolean): void;
}

/** A block in the world. */
export interface BlockHandle {
  /** Its middle and its angle (not wrapped). */
  pose(): Pose;
  /**
   * The hand tool: puts the block there, standing still. It can also move fixed blocks. A block is taken from a robot
   * that holds it; a block that is put on a raised fork is carried.
   */
  place(pose: Pose): void;
  /** Whether a robot holds or carries it. */
  isHeld(): boolean;
  /** Height above the floor at which a robot carries it, in mm; 0 = it lies or is dragged on the floor. */
  liftMm(): number;
}

/** A body that moves by itself: along a way whatever is in its path, or after robots. */
export interface MoverShape extends Named, BodyForm {
  /** At the start. */
  readonly angleRad: number;
  readonly speedMmPerS: number;
  /** How fast it turns about its middle, counter-clockwise positive. */
  readonly spinRadPerS: number;
  readonly goes: Way | Chase;
}

/** A way from stop to stop, without end: its place follows from the time alone. */
export interface Way {
  /** At least one; it is at the first at the start, and waits there first. */
  readonly stops: readonly { readonly atMm: Vec; readonly waitS: number }[];
  /** True if it goes from the last stop straight to the first; otherwise it goes back over all the others. */
  readonly loops: boolean;
  /** It starts where it would be after this time, from 0. */
  readonly phaseS: number;
}

/** A chase after robots, as far as solid things let it. */
export interface Chase {
  /** Its middle at the start. */
  readonly homeMm: Vec;
  /** Robots farther away than this do not matter, from the middle of the box to the middle of the axle; may be `Infinity`. */
  readonly reachMm: number;
  /** True if it goes home while there is no robot for it; otherwise it stays where it is. */
  readonly returns: boolean;
  /** True if it runs after a robot that covers these convex outlines with what it holds (world mm); `null`: after every one. */
  readonly wants: ((bodyMm: readonly (readonly Vec[])[]) => boolean) | null;
}

/** A moving obstacle in the world. */
export interface MoverHandle {
  /** Its middle and its angle (not wrapped). */
  pose(): Pose;
}

/** A line drawn on the floor with a round pen. */
export interface StrokeShape {
  /** A single point makes a dot. */
  readonly pointsMm: readonly Vec[];
  readonly widthMm: number;
  /** In infrared: 0 black … 1 like the bare floor, glossy ones more. */
  readonly reflectance: number;
  /** Its colour; left out: grey, as dark as in infrared. */
  readonly shares?: Shares;
}

/** A painted field on the floor. */
export interface FieldShape extends Omit<BodyForm, keyof Tall> {
  /** Its middle. */
  readonly atMm: Vec;
  readonly angleRad: number;
  /** As of a stroke. */
  readonly reflectance: number;
  readonly shares?: Shares;
}

/** Paint on the floor. */
export interface StrokeHandle {
  /** Changes its place in the painting order: higher layers cover lower ones. Initially that of `addStroke`. */
  setLayer(layer: number): void;
  readonly remove: Stop;
}

/** A picture on the floor for the sensors: a grid of reflectances, painted under all strokes. */
export interface FloorGrid {
  /** Lower left corner. */
  readonly atMm: Vec;
  /** Extent. */
  readonly sizeMm: Vec;
  readonly columns: number;
  readonly rows: number;
  /** A reflectance per cell, 0 black … 1 bare floor, row by row from the upper left. */
  readonly reflectances: Float32Array;
}

/** Corners of a wall in world mm, counter-clockwise. Throws RangeError if it has no length or no thickness. */
export function wallCorners(wall: WallShape): Vec[] {
  const { fromMm: from, toMm: to, thicknessMm } = wall;
  const lengthMm = Math.sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y));
  if (!(lengthMm > 0)) throw new RangeError(`A wall needs a length; this one starts and ends at ${from.x}, ${from.y}.`);
  if (!(thicknessMm > 0)) throw new RangeError(`A wall needs a thickness above 0 mm, not ${thicknessMm}.`);
  const x = (((from.y - to.y) / lengthMm) * thicknessMm) / 2;
  const y = (((to.x - from.x) / lengthMm) * thicknessMm) / 2;
  return [
    { x: from.x - x, y: from.y - y },
    { x: to.x - x, y: to.y - y },
    { x: to.x + x, y: to.y + y },
    { x: from.x + x, y: from.y + y },
  ];
}

/** Corners of a rectangle about the origin, mm, counter-clockwise. */
export function rectangleCorners(sizeMm: Vec): Vec[] {
  const x = sizeMm.x / 2;
  const y = sizeMm.y / 2;
  return [
    { x: -x, y: -y },
    { x, y: -y },
    { x, y },
    { x: -x, y },
  ];
}
