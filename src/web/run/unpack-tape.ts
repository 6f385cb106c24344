import type { Chunk } from '#tape/rows/chunk';
import type { Rows } from '#tape/rows/rows';
import type { Snapshot } from '#simulation/snapshot';

/** Longest stretch of work without a rest, in ms of wall time: half a frame. */
const SLICE_MS = 8;

/** What becomes of the pieces of a tape while they are unpacked. */
export interface Unpacking {
  readonly rows: Rows<Snapshot>;
  /** Looked at before each piece: whether anybody still wants them. */
  readonly isWanted: () => boolean;
  /** A piece is in the rows. */
  readonly onChunk?: (chunk: Chunk) => void;
  /** So far they are there: called before each rest, and at the end. */
  readonly onSome?: () => void;
}

/**
 * Unpacks the pieces of a tape in small slices, the oldest first, so that the page stands still for nobody.
 *
 * @returns whether all are there; if not, nobody wanted them any more
 */
export async function unpackTape(pieces: readonly Uint8Array[], unpacking: Unpacking): Promise<boolean> {
  const { rows, onChunk, onSome } = unpacking;
  let sinceMs = performance.now();
  for (const piece of pieces) {
    if (!unpacking.isWanted()) return false;
    const chunk = rows.push(piece);
    if (chunk !== null) onChunk?.(chunk);
    if (performance.now() - sinceMs < SLICE_MS) continue;
    onSome?.();
    await new Promise((rested) => setTimeout(rested));
    sinceMs = performance.now();
  }
  if (!unpacking.isWanted()) return false;
  onSome?.();
  return true;
}
