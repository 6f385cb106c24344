import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import { Trails } from './trails';
import { addWays } from './ways-of-tape';

/** Longest stretch of work without a rest, in ms of wall time: half a frame. */
const SLICE_MS = 8;

/** The moments of a run, and the ways of its robots by the place of their device. */
export interface RunTape {
  readonly rows: Rows<Snapshot>;
  readonly trails: Trails;
}

/** What becomes of the pieces of a tape while they are unpacked. */
export interface Unpacking {
  readonly into: RunTape;
  /** Number of devices of the run, asked for with each piece. */
  readonly devices: () => number;
  /** Looked at before each piece: whether anybody still wants them. */
  readonly isWanted: () => boolean;
  /** So far they are there: called before each rest, and at the end. */
  readonly onSome?: () => void;
}

/** A tape of which nothing is unpacked yet. */
export const emptyTape = (): RunTape => ({ rows: new Rows<Snapshot>(), trails: new Trails() });

/**
 * Unpacks the pieces of a tape in small slices, the oldest first, so that the page stands still for nobody.
 *
 * @returns whether all are there; if not, nobody wanted them any more
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
