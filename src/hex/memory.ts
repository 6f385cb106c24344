import type { Region } from './firmware';

/** The bytes from an address on; those that are in no region are 0xFF, as in erased flash. */
export function bytesAt(regions: readonly Region[], address: number, length: number): Uint8Array {
  const bytes = new Uint8Array(length).fill(0xff);
  for (const region of regions) {
    const from = Math.max(address, region.address);
    const to = Math.min(address + length, region.address + region.bytes.length);
    if (from < to) bytes.set(region.bytes.subarray(from - region.address, to - region.address), from - address);
  }
  return bytes;
}

/** The number of four bytes at an address, the lowest first. */
export const wordAt = (regions: readonly Region[], address: number): number =>
  viewOf(bytesAt(regions, address, 4)).getUint32(0, true);

export const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/** The regions without everything between two addresses; `to` is the first that stays. */
export const without = (regions: readonly Region[], from: number, to: number): readonly Region[] =>
  regions.flatMap(({ address, bytes }) => {
    const below = bytes.slice(0, Math.max(0, from - address));
    const above = bytes.slice(Math.max(0, to - address));
    const kept = [
      { address, bytes: below },
      { address: Math.max(address, to), bytes: above },
    ];
    return kept.filter((region) => region.bytes.length > 0);
  });

/** True if these letters stand somewhere in the regions. */
export function hasText(regions: readonly Region[], text: string): boolean {
  const wanted = Array.from(text, (sign) => sign.charCodeAt(0));
  const [first = 0] = wanted;
  return regions.some(({ bytes }) => {
    for (let at = bytes.indexOf(first); at >= 0; at = bytes.indexOf(first, at + 1))
      if (wanted.every((code, index) => bytes[at + index] === code)) return true;
    return false;
  });
}

/** The text at an address up to a zero, of at most 256 bytes; empty: there is none. */
export function textAt(regions: readonly Region[], address: number): string {
  const bytes = bytesAt(regions, address, 256);
  const end = bytes.indexOf(0);
  return end < 0 ? '' : new TextDecoder().decode(bytes.subarray(0, end));
}
