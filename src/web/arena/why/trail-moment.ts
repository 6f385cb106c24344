import type { Vec } from '#core/geometry';
import { leavesAt, timesOf, type Chunk } from '#tape/rows/chunk';

/** That a robot came by: how near, and when. */
interface Visit {
  readonly awayMm: number;
  readonly timeUs: number;
}

/** As near as the nearest is who came by this much farther away. Chosen: less than a trail is wide. */
const SAME_MM = 2;
/** Nearer by less is no nearer: a robot that stands has come there when it came to stand. */
const NEARER_MM = 0.5;

/**
 * When a device's robot was at a place, by the tape: the time at which it was nearest, the latest where it came by again.
 *
 * @param untilUs what came later is not to be seen
 * @param reachMm how near counts as there
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
