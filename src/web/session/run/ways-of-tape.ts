import { leavesAt, timesOf, type Chunk } from '#tape/rows/chunk';
import type { Key } from '#tape/rows/leaves';
import type { Trails } from './trails';

/** A step between two moments that no robot drives: the hand has carried it. Chosen: 2 m/s, in mm. */
const CARRIED_MM = 40;

/**
 * Adds the paths of the robots within a piece of a tape to their trails. @param devices number of devices in the run
 */
export function addWays(chunk: Chunk, devices: number, trails: Trails): void {
  const ways = Array.from({ length: devices }, (_, place) => wayIn(chunk, place === 0 ? [] : ['others', place - 1]));
  for (const [at, timeUs] of (timesOf(chunk) ?? []).entries())
    trails.add(
      ways.map((way) => way(at)),
      timeUs,
    );
}

/** The points that a robot adds to its trail at one moment of a piece, as `Trails` takes them. */
function wayIn(chunk: Chunk, device: readonly Key[]): (at: number) => readonly number[] {
  const xs = leavesAt(chunk, [...device, 'robot', 'pose', 'xMm']);
  const ys = leavesAt(chunk, [...device, 'robot', 'pose', 'yMm']);
  return (at) => {
    const [x, y, beforeX, beforeY] = [xs[at], ys[at], xs[at - 1], ys[at - 1]];
    if (typeof x !== 'number' || typeof y !== 'number') return [];
    if (typeof beforeX !== 'number' || typeof beforeY !== 'number') return [x, y];
    const wayMm = Math.hypot(x - beforeX, y - beforeY);
    if (wayMm === 0) return [];
    return wayMm > CARRIED_MM ? [NaN, NaN, x, y] : [x, y];
  };
}
