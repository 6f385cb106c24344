/** Start value of FNV-1a, 32 bits (Fowler, Noll, Vo). */
export const FNV_BASIS = 0x811c9dc5;
const FNV_PRIME = 0x01000193;

/**
 * FNV-1a over the UTF-16 units of a text: enough to distinguish texts, not secure against an attacker.
 *
 * @param before hash to continue from
 * @returns 0 … 2³² − 1
 */
export function fnvOfText(text: string, before: number = FNV_BASIS): number {
  let sum = before;
  for (let index = 0; index < text.length; index += 1) sum = Math.imul(sum ^ text.charCodeAt(index), FNV_PRIME);
  return sum >>> 0;
}

/** The same over bytes. */
export function fnvOfBytes(bytes: Uint8Array, before: number = FNV_BASIS): number {
  let sum = before;
  for (const byte of bytes) sum = Math.imul(sum ^ byte, FNV_PRIME);
  return sum >>> 0;
}
