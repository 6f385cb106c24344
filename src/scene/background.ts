import { deflateSync, Inflate } from 'fflate';
import { fromBase64, toBase64 } from '#core/base64';
import type { Background } from './scene';

/** The level of bare floor, the brightest; 0 is black. */
export const BRIGHTEST_LEVEL = 15;

/**
 * The levels of a background as its file holds them: deflated (RFC 1951) and in base64.
 *
 * @param levels one per cell, row by row from the upper left, 0 … 15
 */
export function packLevels(levels: Uint8Array): string {
  return toBase64(deflateSync(levels, { level: 9 }));
}

/**
 * The levels of a background, one per cell, row by row from the upper left, 0 … 15. Never throws, and stops inflating as
 * soon as there is more than the cells can take.
 *
 * @returns `null` when they are damaged or not as many as there are cells
 */
export function unpackLevels({ cells, levels }: Pick<Background, 'cells' | 'levels'>): Uint8Array | null {
  const packed = fromBase64(levels);
  if (packed === null) return null;
  const inflated = inflate(packed, cells[0] * cells[1]);
  return inflated?.every((level) => level <= BRIGHTEST_LEVEL) ? inflated : null;
}

/** Packed bytes that are inflated before the length is looked at: they become 4 MB at most, as deflate packs 1032 : 1. */
const CHUNK_BYTES = 4096;

function inflate(packed: Uint8Array, count: number): Uint8Array | null {
  const out = new Uint8Array(count);
  let length = 0;
  const stream = new Inflate((piece) => {
    if (length + piece.length <= count) out.set(piece, length);
    length += piece.length;
  });
  try {
    for (let at = 0; at < packed.length && length <= count; at += CHUNK_BYTES)
      stream.push(packed.subarray(at, at + CHUNK_BYTES), at + CHUNK_BYTES >= packed.length);
  } catch {
    return null;
  }
  return length === count ? out : null;
}
