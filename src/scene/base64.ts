const SIGNS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const values = new Map(Array.from(SIGNS, (sign, value) => [sign.charCodeAt(0), value]));
const PAD = '='.charCodeAt(0);

/** Bytes as base64 (RFC 4648 §4, padded). */
export function toBase64(bytes: Uint8Array): string {
  const pieces: string[] = [];
  for (let at = 0; at < bytes.length; at += 3) {
    const [one = 0, two = 0, three = 0] = bytes.subarray(at, at + 3);
    const bits = (one << 16) | (two << 8) | three;
    const signs = [18, 12, 6, 0].map((shift) => SIGNS.charAt((bits >> shift) & 63)).join('');
    pieces.push(at + 2 < bytes.length ? signs : signs.slice(0, bytes.length - at + 1).padEnd(4, '='));
  }
  return pieces.join('');
}

/** The bytes of padded base64, or `null` for a text that is none. */
export function fromBase64(text: string): Uint8Array | null {
  if (text.length % 4 !== 0) return null;
  let end = text.length;
  while (end > text.length - 2 && text.charCodeAt(end - 1) === PAD) end--;
  const bytes = new Uint8Array(Math.floor((end * 3) / 4));
  let bits = 0;
  let length = 0;
  for (let at = 0; at < end; at++) {
    const value = values.get(text.charCodeAt(at));
    if (value === undefined) return null;
    bits = ((bits << 6) | value) & 0xff_ffff;
    const shift = 6 - 2 * (at % 4); // bits of this sign that do not belong to the byte that it fills up
    if (at % 4 !== 0) bytes[length++] = bits >> shift;
  }
  return bytes;
}
