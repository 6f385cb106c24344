import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';
import type { Region } from './firmware';

/** The firmwares that were tried, by the hash of their bytes. Those of the micro:bit are in PyPI's micropython-microbit-fs 0.1.2. */
const tried: Readonly<Record<string, string>> = {
  c568be18fbabc6f9e26952ee21b0179e367eeee2c77fba1fee0edaa788bc50d9: 'micro:bit V1 MicroPython 1.1.1',
  a83366a2b5f542ff8c7a83da248eee33e0b1a02097efc827d372f9a69a4030b2: 'micro:bit V2 MicroPython 2.1.2',
};

/** The name of a firmware that was tried; `null`: it is another one. */
export function knownFirmware(regions: readonly Region[]): string | null {
  return tried[hashOf(regions)] ?? null;
}

/** A hash of addresses and bytes, whatever the lines of the file were. */
export function hashOf(regions: readonly Region[]): string {
  const hash = sha256.create();
  for (const { address, bytes } of regions) hash.update(Uint8Array.of(...numberBytes(address), ...numberBytes(bytes.length))).update(bytes); // prettier-ignore
  return bytesToHex(hash.digest());
}

const numberBytes = (value: number): readonly number[] => [0, 8, 16, 24].map((bits) => (value >>> bits) & 0xff);
