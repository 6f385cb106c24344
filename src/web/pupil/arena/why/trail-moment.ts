import type { Vec } from '#core/geometry';
import { leavesAt, timesOf, type Chunk } from '#tape/rows/chunk';

/** A pass of a robot: its distance and its time. */
interface Visit {
  readonly awayMm: number;
  readonly timeUs: number;
}

/** A pass that is farther away by less than this counts as equally near. Chosen: less than a trail is wide. */
const SAME_MM = 2;
/** A smaller gain is not nearer: a robot at rest is dated to the moment when it came to rest. */
const NEARER_MM = 0.5;

/**
 * Time at which a device's robot was at a place, by the tape: when it was nearest, the latest of several passes.
 *
 * @param untilUs later passes are hidden
 * @param reachMm distance that counts as there
 */
export function momentAt(
  chunks: readonly Chunk[],
  { device, at, untilUs, reachMm }: { device: number; at: Vec; untilUs: number; reachMm: number },
): number | null {
  const path = [...(device === 0 ? [] : ['others', device - 1]), 'robot', 'pose'];
  const visits: Visit[] = [];
  let visit: Visit | null = null;
  for (const chunk of chunks) {
    const [xs, ys] = [leavesAt(chunk, [...path, 'xMm']), leavesAt(chunk, [...path, 'yMm'])];
    for (const [row, timeUs] of (timesOf(chunk) ?? []).entries()) {
      const awayMm = timeUs > untilUs ? Infinity : distance(xs[row], ys[row], at);
      if (awayMm > reachMm) visit = null;
      else if (visit === null) visits.push((visit = { awayMm, timeUs }));
      else if (awayMm < visit.awayMm - NEARER_MM) visits[visits.length - 1] = visit = { awayMm, timeUs };
    }
  }
  const nearestMm = Math.min(...visits.map(({ awayMm }) => awayMm));
  return visits.findLast(({ awayMm }) => awayMm <= nearestMm + SAME_MM)?.timeUs ?? null;
}

const distance = (x: unknown, y: unknown, at: Vec): number =>
  typeof x === 'number' && typeof y === 'number' ? Math.hypot(x - at.x, y - at.y) : Infinity;
