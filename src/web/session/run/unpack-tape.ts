import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import { Trails } from './trails';
import { addWays } from './ways-of-tape';

/** Longest stretch of work without a rest, in ms of wall time: half a frame. */
const SLICE_MS = 8;

/** The moments of a run, and the trails of its robots by the place of their device. */
export interface RunTape {
  readonly rows: Rows<Snapshot>;
  readonly trails: Trails;
}

/** The options of unpacking. */
export interface Unpacking {
  readonly into: RunTape;
  /** Number of devices of the run, read with each piece. */
  readonly devices: () => number;
  /** Called before each piece: false if they are no longer wanted. */
  readonly isWanted: () => boolean;
  /** Some are ready: called before each rest, and at the end. */
  readonly onSome?: () => void;
}

/** A tape of which nothing is unpacked yet. */
export const emptyTape = (): RunTape => ({ rows: new Rows<Snapshot>(), trails: new Trails() });

/**
 * Unpacks the pieces of a tape in small slices, the oldest first, so that the page never freezes.
 *
 * @returns true if all are unpacked, false if they were no longer wanted
 */
export async function unpackTape(pieces: readonly Uint8Array[], unpacking: Unpacking): Promise<boolean> {
  const { into, devices, isWanted, onSome } = unpacking;
  let sinceMs = performance.now();
  for (const piece of pieces) {
    if (!isWanted()) return false;
    const chunk = into.rows.push(piece);
    if (chunk !== null) addWays(chunk, devices(), into.trails);
    if (performance.now() - sinceMs < SLICE_MS) continue;
    onSome?.();
    await new Promise((rested) => setTimeout(rested));
    sinceMs = performance.now();
  }
  if (!isWanted()) return false;
  onSome?.();
  return true;
}
