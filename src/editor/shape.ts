import type { Vec } from '#core/geometry';
import {
  boundsMeet,
  boundsOf,
  boundsOfOutline,
  boxOutline,
  labelOutline,
  movedOutline,
  overlapMm,
  solidOutline,
  squaredDistance,
  type Bounds,
  type Outline,
} from '#scene/outline';
import type { Point, RobotStart, SceneObject, Stroke, Zone } from '#scene/scene';
import { exactCos, exactSin } from '#core/exact-math';
import { toVec } from './plane';

const kept = new WeakMap<SceneObject, Bounds>();

/** The upright rectangle around an object, kept for as long as the object: it is asked for on every move of a pointer. */
export function boundsAround(object: SceneObject): Bounds {
  const known = kept.get(object);
  if (known) return known;
  const bounds = boundsOf(object);
  kept.set(object, bounds);
  return bounds;
}

/** A rectangle made larger on all sides. */
export const grown = ({ minX, minY, maxX, maxY }: Bounds, byMm: number): Bounds => ({
  minX: minX - byMm,
  minY: minY - byMm,
  maxX: maxX + byMm,
  maxY: maxY + byMm,
});

/** The rectangle around several; `null` for none. */
export function boundsAll(all: readonly Bounds[]): Bounds | null {
  const [first, ...rest] = all;
  return first === undefined
    ? null
    : rest.reduce(
        (one, other) => ({
          minX: Math.min(one.minX, other.minX),
          minY: Math.min(one.minY, other.minY),
          maxX: Math.max(one.maxX, other.maxX),
          maxY: Math.max(one.maxY, other.maxY),
        }),
        first,
      );
}

/** The four corners of an upright rectangle. */
export const cornersOf = ({ minX, minY, maxX, maxY }: Bounds): Outline => [
  { x: minX, y: minY },
  { x: maxX, y: minY },
  { x: maxX, y: maxY },
  { x: minX, y: maxY },
];

/** Corners of the outline that stands for an ellipse. Chosen: within 1 mm of an ellipse of 400 mm. */
const ELLIPSE_CORNERS = 32;

/** What can be seen and hit of everything but strokes, as one convex outline; a mover where it starts. */
export function outlineOf(object: Exclude<SceneObject, Stroke>): Outline {
  switch (object.type) {
    case 'wall':
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'mover':
      return solidOutline(object) ?? [];
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return object.round ? ellipseOutline(object) : boxOutline(object);
    case 'label':
      return labelOutline(object);
    default:
      return object satisfies never;
  }
}

function ellipseOutline({ at, size, turn }: Zone): Outline {
  const corners = Array.from({ length: ELLIPSE_CORNERS }, (_, i) => {
    const angle = (i * 2 * Math.PI) / ELLIPSE_CORNERS;
    return { x: (exactCos(angle) * size[0]) / 2, y: (exactSin(angle) * size[1]) / 2 };
  });
  const direction = { x: exactCos((turn * Math.PI) / 4), y: exactSin((turn * Math.PI) / 4) };
  return movedOutline(corners, { x: at[0], y: at[1] }, direction);
}

/** The outlines of the robot at its start, in world mm. */
export function robotOutlines(robot: RobotStart, footprint: readonly Outline[]): readonly Outline[] {
  const angle = (robot.heading * Math.PI) / 180;
  const direction = { x: exactCos(angle), y: exactSin(angle) };
  return footprint.map((part) =>
    movedOutline(
      part.map(({ x, y }) => ({ x: x * robot.scale, y: y * robot.scale })),
      { x: robot.at[0], y: robot.at[1] },
      direction,
    ),
  );
}

/** How far a place is from a convex outline in mm; 0 inside. */
export function distanceToOutline(outline: Outline, place: Vec): number {
  let squared = Infinity;
  let lefts = 0;
  let rights = 0;
  outline.forEach((from, index) => {
    const to = outline[(index + 1) % outline.length] ?? from;
    squared = Math.min(squared, squaredDistance(place, from, to));
    const side = (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
    if (side > 0) lefts += 1;
    if (side < 0) rights += 1;
  });
  return outline.length > 2 && (lefts === 0 || rights === 0) ? 0 : Math.sqrt(squared);
}

/** How far a place is from an object in mm, at most `reachMm`; 0 on it, `null` when it is farther away. */
export function distanceTo(object: SceneObject, place: Vec, reachMm: number): number | null {
  if (!holds(grown(boundsAround(object), reachMm), place)) return null;
  const mm = object.type === 'stroke' ? distanceToStroke(object, place) : distanceToOutline(outlineOf(object), place);
  return mm <= reachMm ? mm : null;
}

const holds = ({ minX, minY, maxX, maxY }: Bounds, { x, y }: Vec): boolean =>
  x >= minX && x <= maxX && y >= minY && y <= maxY;

function distanceToStroke({ points, width }: Stroke, place: Vec): number {
  let squared = Infinity;
  let before = points[0];
  for (const point of points) {
    const [fromX, fromY] = before ?? point;
    squared = Math.min(squared, squaredDistance(place, { x: fromX, y: fromY }, { x: point[0], y: point[1] }));
    before = point;
  }
  return Math.max(0, Math.sqrt(squared) - width / 2);
}

/** Whether an object has a place in common with a convex outline (also a straight piece of two places); the edge counts. */
export function meets(object: SceneObject, outline: Outline, around: Bounds = boundsOfOutline(outline)): boolean {
  const bounds = boundsAround(object);
  if (!boundsMeet(bounds, around)) return false;
  if (object.type !== 'stroke') return overlapMm(outlineOf(object), outline) >= 0;
  const reachMm = object.width / 2;
  return somePiece(object, around, (from, to) => overlapMm([toVec(from), toVec(to)], outline) >= -reachMm);
}

/** Whether a part of a stroke may lie in a rectangle: the rectangle around one of its pieces does. */
export const comesNear = (stroke: Stroke, around: Bounds): boolean => somePiece(stroke, around, () => true);

/** Whether something holds for one of those pieces of a stroke that come near a rectangle. Most are ruled out quickly. */
function somePiece(
  { points, width }: Stroke,
  { minX, minY, maxX, maxY }: Bounds,
  holds: (from: Point, to: Point) => boolean,
): boolean {
  const reachMm = width / 2;
  let before = points[0];
  for (const point of points) {
    const from = before ?? point;
    before = point;
    if (Math.min(from[0], point[0]) - reachMm > maxX || Math.max(from[0], point[0]) + reachMm < minX) continue;
    if (Math.min(from[1], point[1]) - reachMm > maxY || Math.max(from[1], point[1]) + reachMm < minY) continue;
    if (holds(from, point)) return true;
  }
  return false;
}

/** The arena as a rectangle. */
export const arenaBounds = ([width, height]: Point): Bounds => ({ minX: 0, minY: 0, maxX: width, maxY: height });
