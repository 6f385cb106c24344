import { shallowRef, triggerRef, watch, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { leavesAt, timesOf, type Chunk } from '#tape/rows/chunk';
import type { Key } from '#tape/rows/leaves';
import { Rows } from '#tape/rows/rows';
import { Trails } from '../../run/trails';
import { unpackTape } from '../../run/unpack-tape';

/** A tape that is being unpacked. */
export interface GhostTape {
  readonly rows: Rows<Snapshot>;
  /** The ways of its robots, by the place of their device. */
  readonly trails: Trails;
  /** All of it is there. */
  isWhole: boolean;
}

/** The tape whose pieces these are, as far as it is unpacked; it triggers as more comes. */
export function useGhostTape(
  pieces: () => readonly Uint8Array[],
  devices: () => number,
): Readonly<ShallowRef<GhostTape>> {
  const empty = (): GhostTape => ({ rows: new Rows<Snapshot>(), trails: new Trails(), isWhole: false });
  const tape = shallowRef(empty());
  watch(
    pieces,
    (all) => {
      const mine = (tape.value = empty());
      void unpackTape(all, {
        rows: mine.rows,
        isWanted: () => tape.value === mine,
        onChunk: (chunk) => addWays(chunk, devices(), mine.trails),
        onSome: () => triggerRef(tape),
      }).then((isWhole) => {
        if (!isWhole) return;
        mine.isWhole = true;
        triggerRef(tape);
      });
    },
    { immediate: true },
  );
  return tape;
}

/** A step between two moments that no robot drives: the hand has carried it. Chosen: 2 m/s, in mm. */
const CARRIED_MM = 40;

/** The ways of the robots within a piece. */
function addWays(chunk: Chunk, devices: number, trails: Trails): void {
  const ways = Array.from({ length: devices }, (_, place) => wayIn(chunk, place === 0 ? [] : ['others', place - 1]));
  for (const [at, timeUs] of (timesOf(chunk) ?? []).entries())
    trails.add(
      ways.map((way) => way(at)),
      timeUs,
    );
}

/** What a robot adds to its way at one moment of a piece, as `Trails` takes it. */
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
