import { fromBase64, toBase64 } from '#core/base64';
import { packed, unpacked } from '#core/deflate';
import type { Background } from './scene';

/** The level of bare floor, the brightest; 0 is black. */
export const BRIGHTEST_LEVEL = 15;

/**
 * The levels of a background as its file holds them: deflated (RFC 1951) and in base64.
 *
 * @param levels one per cell, row by row from the upper left, 0 … 15
 */
export function packLevels(levels: Uint8Array): string {
  return toBase64(packed(levels));
}

/**
 * The levels of a background, one per cell, row by row from the upper left, 0 … 15. Never throws, and stops inflating as
 * soon as there is more than the cells can take.
 *
 * @returns `null` when they are damaged or not as many as there are cells
 */
export function unpackLevels({ cells, levels }: Pick<Background, 'cells' | 'levels'>): Uint8Array | null {
  const count = cells[0] * cells[1];
  const bytes = fromBase64(levels);
  const all = bytes && unpacked(bytes, count);
  if (!(all instanceof Uint8Array) || all.length !== count) return null;
  return all.every((level) => level <= BRIGHTEST_LEVEL) ? all : null;
}
