import type { Pose, Vec } from '#core/geometry';
import { solidParts } from '#scene/kinds/index';
import { zoneHolds } from '#scene/kinds/zone';
import { boundsOfOutline, lengthOf, movedOutline, overlapMm, type Outline } from '#scene/outline';
import type { Scene, SceneObject, Zone } from '#scene/scene';
import { ownParts } from '#scene/shape/shape';

/** The things that a robot can bump into; `edge`: the edge of the arena. */
export type Solid = 'wall' | 'block' | 'fixed-block' | 'spikes' | 'mover' | 'barrier' | 'edge';

/** A place on a thing that is near something. */
export interface Near {
  readonly what: Solid;
  /** The object's id, or `null` for the edge. */
  readonly id: string | null;
  readonly atMm: Vec;
  readonly mm: number;
}

/** An object up to this much farther away than the edge of the arena counts as what a sensor meets, in mm. */
const LIKE_EDGE_MM = 1;

/**
 * An object's convex parts where they are now: blocks are pushed, obstacles move. None of what lies flat on the floor.
 */
export function partsNow(object: SceneObject, moved: Readonly<Record<string, Pose>>): readonly Outline[] {
  const pose = moved[object.id];
  if (pose === undefined || !('size' in object)) return solidParts(object);
  return ownParts(object).map((part) => movedOutline(part, vecOf(pose), directionOf(pose)));
}

/** The nearest thing that a robot can bump into. */
export function nearestSolid(at: Vec, scene: Scene, moved: Readonly<Record<string, Pose>>): Near {
  let nearest = edgeNear(at, scene);
  for (const object of scene.objects) {
    const parts = partsNow(object, moved);
    if (parts.length === 0) continue;
    const atMm = nearestOnParts(parts, at);
    const mm = lengthOf(atMm.x - at.x, atMm.y - at.y);
    if (mm < nearest.mm + (nearest.id === null ? LIKE_EDGE_MM : 0))
      nearest = { what: object.type as Solid, id: object.id, atMm, mm };
  }
  return nearest;
}

/**
 * The thing that a robot's body overlaps most, or else is nearest to.
 *
 * @param body convex parts in the robot's frame, at its size
 */
export function deepestSolid(
  body: readonly Outline[],
  pose: Pose,
  scene: Scene,
  moved: Readonly<Record<string, Pose>>,
): Near {
  const parts = body.map((part) => movedOutline(part, vecOf(pose), directionOf(pose)));
  let touched = edgeNear(vecOf(pose), scene);
  let deepest = Math.max(...parts.map((part) => beyondEdge(part, scene)));
  for (const object of scene.objects) {
    const others = partsNow(object, moved);
    const depth = Math.max(...parts.flatMap((part) => others.map((other) => overlapMm(part, other))));
    if (depth <= deepest) continue;
    deepest = depth;
    const atMm = nearestOnParts(others, vecOf(pose));
    touched = { what: object.type as Solid, id: object.id, atMm, mm: 0 };
  }
  return touched;
}

/** How far an outline reaches beyond the edge of the arena, in mm; negative: its distance from the edge. */
function beyondEdge(outline: Outline, { size: [width, height] }: Scene): number {
  const { minX, minY, maxX, maxY } = boundsOfOutline(outline);
  return Math.max(-minX, -minY, maxX - width, maxY - height);
}

/** The nearest place of the arena's edge. */
export function edgeNear(at: Vec, { size: [width, height] }: Scene): Near {
  const places: readonly Vec[] = [
    { x: 0, y: at.y },
    { x: width, y: at.y },
    { x: at.x, y: 0 },
    { x: at.x, y: height },
  ];
  const [first = at, ...others] = places;
  const mmTo = (to: Vec): number => lengthOf(to.x - at.x, to.y - at.y);
  const atMm = others.reduce((nearest, one) => (mmTo(one) < mmTo(nearest) ? one : nearest), first);
  return { what: 'edge', id: null, atMm, mm: mmTo(atMm) };
}

/** The nearest place on or inside several convex outlines. */
export function nearestOnParts(parts: readonly Outline[], at: Vec): Vec {
  const places = parts.map((part) => nearestOn(part, at));
  const mmTo = (to: Vec): number => lengthOf(to.x - at.x, to.y - at.y);
  return places.reduce((nearest, one) => (mmTo(one) < mmTo(nearest) ? one : nearest));
}

/** The nearest place on or inside a convex outline. */
export function nearestOn(outline: Outline, at: Vec): Vec {
  return isInside(outline, at) ? at : nearestOfLine([...outline, ...outline.slice(0, 1)], at);
}

/** The nearest place on straight lines from point to point. */
export function nearestOfLine(points: readonly Vec[], at: Vec): Vec {
  let nearest = points[0] ?? at;
  let least = Infinity;
  for (const [i, from] of points.entries()) {
    const to = points[i + 1] ?? from;
    const place = nearestBetween(from, to, at);
    const mm = lengthOf(place.x - at.x, place.y - at.y);
    if (mm < least) [nearest, least] = [place, mm];
  }
  return nearest;
}

function nearestBetween(from: Vec, to: Vec, at: Vec): Vec {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const squared = dx * dx + dy * dy;
  const share = squared === 0 ? 0 : ((at.x - from.x) * dx + (at.y - from.y) * dy) / squared;
  const along = Math.max(0, Math.min(1, share));
  return { x: from.x + along * dx, y: from.y + along * dy };
}

/** True if a place is on what lies flat on the floor. A text is no thing to stand on. */
export function isOn(object: SceneObject, at: Vec): boolean {
  if (object.type === 'stroke') {
    const near = nearestOfLine(
      object.points.map(([x, y]) => ({ x, y })),
      at,
    );
    return lengthOf(near.x - at.x, near.y - at.y) <= object.width / 2;
  }
  return isZone(object) && zoneHolds(object, at);
}

const isZone = (object: SceneObject): object is Zone => 'number' in object;

/** True if a place is inside a convex outline, clockwise or counter-clockwise. */
function isInside(outline: Outline, { x, y }: Vec): boolean {
  const sides = outline.map((from, i) => {
    const to = outline[(i + 1) % outline.length] ?? from;
    return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}

export const vecOf = ({ xMm: x, yMm: y }: Pose): Vec => ({ x, y });

/** The direction in which a body looks, as a vector of length 1. */
export const directionOf = ({ headingRad }: Pose): Vec => ({ x: Math.cos(headingRad), y: Math.sin(headingRad) });

/** A place as the robot has it: x ahead of it, y to its left, in mm. */
export function fromRobot(pose: Pose, at: Vec): Vec {
  const { x: cos, y: sin } = directionOf(pose);
  const [dx, dy] = [at.x - pose.xMm, at.y - pose.yMm];
  return { x: dx * cos + dy * sin, y: dy * cos - dx * sin };
}
