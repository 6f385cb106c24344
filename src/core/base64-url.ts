import { fromBase64, toBase64 } from './base64';

/** Bytes as text of A–Z a–z 0–9 - _ alone (RFC 4648 §5, no padding), which addresses and collectors of links leave as it is. */
export function toBase64Url(bytes: Uint8Array): string {
  return toBase64(bytes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The bytes of base64 text in either alphabet, padded or not; `null` for any other text. */
export function fromBase64Url(text: string): Uint8Array | null {
  const bare = text
    .replace(/={1,2}$/, '')
    .replaceAll('-', '+')
    .replaceAll('_', '/');
  return bare.length % 4 === 1 ? null : fromBase64(bare.padEnd(Math.ceil(bare.length / 4) * 4, '='));
}
