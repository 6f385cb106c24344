import { degOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import type { PlacedPose } from '#simulation/input';
import type { ArenaSize } from '../view/view-transform';

/** The hand's grip on a thing. */
export type Grip =
  /**
   * By its body: the pointer stays on the same point of it. `offsetMm` leads from the pointer to the thing's origin;
   * `pointMm` is the place of the pointer.
   */
  | { readonly kind: 'move'; readonly offsetMm: Vec; readonly pointMm: Vec; readonly armMm: number }
  /**
   * By the ring: the thing faces the pointer. `offsetRad` is its heading at the start less the direction to the
   * pointer.
   */
  | { readonly kind: 'turn'; readonly offsetRad: number };

/** Movement of the robot per key press: mm, and with Shift. Chosen: a ruler's mark, and the smallest whole step. */
const NUDGE_MM = { coarse: 10, fine: 1 };

/** Rotation of the robot per key press: rad, and with Shift. */
const NUDGE_RAD = { coarse: Math.PI / 12, fine: Math.PI / 180 };

/**
 * Grips a thing by its body.
 *
 * @param armMm least distance at which the thing trails behind the pointer, see `pulledPose`
 */
export function gripBody(pose: Pose, pointMm: Vec, armMm = 0): Grip {
  return { kind: 'move', offsetMm: { x: pose.xMm - pointMm.x, y: pose.yMm - pointMm.y }, pointMm, armMm };
}

/** Grips the ring around a thing. */
export function gripRing(pose: Pose, pointMm: Vec): Grip {
  return { kind: 'turn', offsetRad: pose.headingRad - bearing(pose, pointMm) };
}

/** Pose of the thing when the pointer that holds it is at `pointMm`. */
export function heldPose(grip: Grip, pose: Pose, pointMm: Vec): Pose {
  switch (grip.kind) {
    case 'move':
      return { ...pose, xMm: pointMm.x + grip.offsetMm.x, yMm: pointMm.y + grip.offsetMm.y };
    case 'turn':
      return { ...pose, headingRad: bearing(pose, pointMm) + grip.offsetRad };
    default:
      return grip satisfies never;
  }
}

/** Nearer to its middle than this, in mm, a thing counts as held by its front. */
const MIDDLE_MM = 4;

/**
 * The longest step that is pulled at a time, as a share of the arm: a jump of the pointer must not turn a thing over.
 */
const STEP = 0.25;

/** The outcome of pulling a thing. */
export interface Pulled {
  readonly pose: Pose;
  readonly grip: Grip;
}

/**
 * The pose of a thing whose body is pulled to another place: it follows like a trailer (its middle runs on a tractrix),
 * so it turns into the direction of the drag. A thing held near its middle turns as if it were pulled by its front, at
 * the end of the grip's arm.
 */
export function pulledPose(grip: Extract<Grip, { kind: 'move' }>, pose: Pose, toMm: Vec): Pulled {
  const held = { x: -grip.offsetMm.x, y: -grip.offsetMm.y };
  const reach = Math.hypot(held.x, held.y);
  const armMm = Math.max(reach, grip.armMm);
  const startRad = reach < MIDDLE_MM ? pose.headingRad : Math.atan2(held.y, held.x);
  const turnRad = normalAngle(trailedRad(startRad, armMm, grip.pointMm, toMm) - startRad);
  const [cos, sin] = [Math.cos(turnRad), Math.sin(turnRad)];
  const offsetMm = {
    x: grip.offsetMm.x * cos - grip.offsetMm.y * sin,
    y: grip.offsetMm.x * sin + grip.offsetMm.y * cos,
  };
  return {
    pose: { xMm: toMm.x + offsetMm.x, yMm: toMm.y + offsetMm.y, headingRad: pose.headingRad + turnRad },
    grip: { ...grip, offsetMm, pointMm: toMm },
  };
}

/** The direction of an arm that trails behind a place going straight from one point to another. */
function trailedRad(startRad: number, armMm: number, from: Vec, to: Vec): number {
  const way = { x: to.x - from.x, y: to.y - from.y };
  const length = Math.hypot(way.x, way.y);
  if (armMm <= 0 || length === 0) return startRad;
  const steps = Math.min(400, Math.ceil(length / (armMm * STEP)));
  let rad = startRad;
  for (let i = 0; i < steps; i += 1)
    rad = Math.atan2(
      armMm * Math.sin(rad) + way.y / steps,
      armMm * Math.cos(rad) + way.x / steps, // from the trailing end to where the pointer is now
    );
  return rad;
}

/** The heading after a twist of two fingers that were at `from` and are at `to` (world mm each). */
export function twistedHeading(headingRad: number, from: readonly [Vec, Vec], to: readonly [Vec, Vec]): number {
  return headingRad + normalAngle(direction(to[0], to[1]) - direction(from[0], from[1]));
}

/**
 * The pose after a key of the arena, or `null` for a key that means nothing: arrows move along the axes of the arena,
 * Q turns to the left, E to the right.
 */
export function nudgedPose(pose: Pose, key: string, fine: boolean): Pose | null {
  const mm = fine ? NUDGE_MM.fine : NUDGE_MM.coarse;
  const rad = fine ? NUDGE_RAD.fine : NUDGE_RAD.coarse;
  switch (key.length === 1 ? key.toLowerCase() : key) {
    case 'ArrowLeft':
      return { ...pose, xMm: pose.xMm - mm };
    case 'ArrowRight':
      return { ...pose, xMm: pose.xMm + mm };
    case 'ArrowUp':
      return { ...pose, yMm: pose.yMm + mm };
    case 'ArrowDown':
      return { ...pose, yMm: pose.yMm - mm };
    case 'q':
      return { ...pose, headingRad: pose.headingRad + rad };
    case 'e':
      return { ...pose, headingRad: pose.headingRad - rad };
    default:
      return null;
  }
}

/**
 * The heading of the held thing after a turn of the mouse wheel: 15° per notch of 100 px, downward to the right, 45° at
 * most.
 */
export function wheelTurnedHeading(headingRad: number, deltaPx: number): number {
  return headingRad - (Math.max(-300, Math.min(300, deltaPx)) / 100) * NUDGE_RAD.coarse;
}

/**
 * Moves the origin of a thing to at least `marginMm` from the edge of the arena (to its middle if that is too narrow).
 */
export function keepInside(pose: Pose, arena: ArenaSize, marginMm: number): Pose {
  const clamp = (value: number, size: number): number => {
    const margin = Math.min(marginMm, size / 2);
    return Math.max(margin, Math.min(size - margin, value));
  };
  return { ...pose, xMm: clamp(pose.xMm, arena[0]), yMm: clamp(pose.yMm, arena[1]) };
}

/** The pose for messages: tenths of a mm and of a degree. */
export function placedPose(pose: Pose): PlacedPose {
  const tenths = (value: number): number => Math.round(value * 10) / 10 + 0; // + 0 makes −0 a 0
  const deg = tenths(degOf(normalAngle(pose.headingRad)));
  return { xMm: tenths(pose.xMm), yMm: tenths(pose.yMm), headingDeg: deg <= -180 ? 180 : deg };
}

/** The same angle within −π … π. */
export function normalAngle(rad: number): number {
  return rad - 2 * Math.PI * Math.round(rad / (2 * Math.PI));
}

function bearing(pose: Pose, pointMm: Vec): number {
  return direction({ x: pose.xMm, y: pose.yMm }, pointMm);
}

function direction(from: Vec, to: Vec): number {
  return Math.atan2(to.y - from.y, to.x - from.x);
}
