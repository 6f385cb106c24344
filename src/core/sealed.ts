import { fromBase64Url, toBase64Url } from './base64-url';
import { fnvOfBytes } from './fnv';

/** The checksum (FNV-1a, lowest byte first) precedes the bytes. */
const SUM_BYTES = 4;

/** Bytes as text for an address, with a checksum: a link that was cut short is noticed. */
export function sealed(bytes: Uint8Array): string {
  const all = new Uint8Array(SUM_BYTES + bytes.length);
  new DataView(all.buffer).setUint32(0, fnvOfBytes(bytes), true);
  all.set(bytes, SUM_BYTES);
  return toBase64Url(all);
}

/** The bytes in such a text; `null` where something of it is missing or changed. */
export function unsealed(text: string): Uint8Array | null {
  const all = fromBase64Url(text);
  if (all === null || all.length <= SUM_BYTES) return null;
  const bytes = all.subarray(SUM_BYTES);
  const sum = new DataView(all.buffer, all.byteOffset).getUint32(0, true);
  return sum === fnvOfBytes(bytes) ? bytes : null;
}
