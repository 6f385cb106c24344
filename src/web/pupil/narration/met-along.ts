import type { Pose, Vec } from '#core/geometry';
import { arenaOutline, type Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';

import { fromRobot, partsNow } from './solids';

/** A place and a direction to look along. */
export interface Look {
  /** The place, and the heading to look along. */
  readonly pose: Pose;
  readonly scene: Scene;
  readonly moved: Readonly<Record<string, Pose>>;
  /** The robot's body in its own frame; empty: a place alone. */
  readonly body: readonly Outline[];
  /** Number of quarter turns, counter-clockwise, from the robot's heading to that of `pose`. */
  readonly quarter: number;
}

/** Half the width of the look without a body, in mm. Chosen: as a finger. */
const FINGER_MM = 10;

/**
 * The object that the robot would hit, moving straight in that direction: the object's id, or `null` for the edge of
 * the arena, and how far it is from the body, in mm.
 */
export function metAlong({ pose, scene, moved, body, quarter }: Look): {
  readonly id: string | null;
  readonly mm: number;
} {
  const { aheadMm, halfMm } = reach(body, quarter);
  const distance = (outline: Outline): number =>
    firstAlong(
      outline.map((at) => fromRobot(pose, at)),
      halfMm,
    );
  let met: { id: string | null; mm: number } = { id: null, mm: distance(arenaOutline(scene.size)) };
  for (const object of scene.objects) {
    const mm = Math.min(...partsNow(object, moved).map(distance));
    if (mm < met.mm) met = { id: object.id, mm };
  }
  return { id: met.id, mm: Math.max(0, met.mm - aheadMm) };
}

/** How far a body reaches in a direction, and half its width across it, in mm. */
function reach(body: readonly Outline[], quarter: number): { readonly aheadMm: number; readonly halfMm: number } {
  const turned = body.flat().map((at) => quarterBack(at, quarter));
  if (turned.length === 0) return { aheadMm: 0, halfMm: FINGER_MM };
  return {
    aheadMm: Math.max(...turned.map(({ x }) => x)),
    halfMm: Math.max(...turned.map(({ y }) => Math.abs(y))),
  };
}

function quarterBack({ x, y }: Vec, quarter: number): Vec {
  if (quarter === 1) return { x: y, y: -x };
  if (quarter === 2) return { x: -x, y: -y };
  return quarter === 3 ? { x: -y, y: x } : { x, y };
}

/** How far ahead (+x) an outline begins within a band around the x axis, in mm; `Infinity`: it does not. */
function firstAlong(outline: Outline, halfMm: number): number {
  let least = Infinity;
  for (const [i, from] of outline.entries()) {
    const to = outline[(i + 1) % outline.length] ?? from;
    for (const { x, y } of [from, to]) if (Math.abs(y) <= halfMm && x >= 0) least = Math.min(least, x);
    for (const edge of [-halfMm, halfMm]) {
      if ((from.y - edge) * (to.y - edge) >= 0) continue;
      const x = from.x + ((edge - from.y) / (to.y - from.y)) * (to.x - from.x);
      if (x >= 0) least = Math.min(least, x);
    }
  }
  return least;
}
