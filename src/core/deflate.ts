import { deflateSync, Inflate } from 'fflate';

/**
 * Bytes in deflate's format (RFC 1951), as small as it can.
 *
 * @param dictionary likely content of the bytes; needed again to unpack them
 */
export function packed(bytes: Uint8Array, dictionary?: Uint8Array): Uint8Array {
  return deflateSync(bytes, dictionary === undefined ? { level: 9 } : { level: 9, dictionary });
}

/** Bytes fed in at a time. Deflate makes at most 1032 bytes of one, so the limit is exceeded by 1 MB at most. */
const CHUNK_BYTES = 1024;

class TooLarge extends Error {}

/**
 * Unpacks deflated bytes, and stops as soon as there are too many.
 *
 * @param maxBytes maximum of the output
 */
export function unpacked(
  bytes: Uint8Array,
  maxBytes: number,
  dictionary?: Uint8Array,
): Uint8Array | 'damaged' | 'too-large' {
  const pieces: Uint8Array[] = [];
  let length = 0;
  let isWhole = false;
  const inflate = new Inflate(dictionary === undefined ? {} : { dictionary }, (piece, isLast) => {
    length += piece.length;
    if (length > maxBytes) throw new TooLarge();
    pieces.push(piece);
    isWhole ||= isLast;
  });
  try {
    for (let at = 0; at < bytes.length; at += CHUNK_BYTES)
      inflate.push(bytes.subarray(at, at + CHUNK_BYTES), at + CHUNK_BYTES >= bytes.length);
  } catch (error) {
    return error instanceof TooLarge ? 'too-large' : 'damaged';
  }
  if (!isWhole) return 'damaged';
  const all = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}
