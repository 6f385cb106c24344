import type { Region } from './firmware';

/** Kinds of records: Intel's, and those of the universal hex (spec-universal-hex 0.4.0). */
export const DATA = 0x00;
export const END = 0x01;
export const SEGMENT = 0x02;
export const START_SEGMENT = 0x03;
export const UPPER = 0x04;
export const START_LINEAR = 0x05;
export const BLOCK_START = 0x0a;
export const BLOCK_END = 0x0b;
export const PADDING = 0x0c;
export const CUSTOM_DATA = 0x0d;
export const OTHER_DATA = 0x0e;

/** The line that ends a hex. */
export const LAST_LINE = ':00000001FF\n';

/** Bytes of a data record, as in all known hexes: apps on tablets look for the table of the flash within one line. */
const LINE_BYTES = 16;
const COLON = 0x3a;
const LINE_END = 0x0a;
/** The signs of the 16 digits. */
const DIGITS = Uint8Array.from('0123456789ABCDEF', (digit) => digit.charCodeAt(0));

/** Signs of a record with its line end. */
const lineLength = (count: number): number => 2 * count + 12;

/** A record as a line. */
export function record(type: number, offset: number, data: ArrayLike<number>): string {
  const lines = new Lines(lineLength(data.length));
  lines.add(type, offset, data);
  return lines.text();
}

/**
 * The data records of regions in the order of their addresses.
 *
 * @param type `DATA`, or `CUSTOM_DATA` for a board that shares the file with an older one
 */
export function dataRecords(regions: readonly Region[], type: number): string {
  const bytes = regions.reduce((sum, region) => sum + region.bytes.length, 0);
  const lines = new Lines(lineLength(LINE_BYTES) * (bytes / LINE_BYTES + 2 * regions.length + 16));
  let upper = -1;
  for (const region of regions) {
    for (let at = 0; at < region.bytes.length;) {
      const address = region.address + at;
      if (address >>> 16 !== upper) {
        upper = address >>> 16;
        lines.add(UPPER, 0, [upper >>> 8, upper & 0xff]);
      }
      const offset = address & 0xffff;
      const line = region.bytes.subarray(at, at + Math.min(LINE_BYTES, 0x10000 - offset));
      lines.add(type, offset, line);
      at += line.length;
    }
  }
  return lines.text();
}

/** Lines in the making: as bytes, which is ten times quicker than by texts. */
class Lines {
  private bytes: Uint8Array;
  private length = 0;

  /** @param most signs that are expected */
  constructor(most: number) {
    this.bytes = new Uint8Array(Math.ceil(most));
  }

  add(type: number, offset: number, data: ArrayLike<number>): void {
    this.makeRoom(lineLength(data.length));
    this.bytes[this.length++] = COLON;
    let sum = this.put(data.length) + this.put(offset >>> 8) + this.put(offset & 0xff) + this.put(type);
    for (let place = 0; place < data.length; place++) sum += this.put(data[place] ?? 0);
    this.put(-sum & 0xff);
    this.bytes[this.length++] = LINE_END;
  }

  text(): string {
    return new TextDecoder().decode(this.bytes.subarray(0, this.length));
  }

  private put(byte: number): number {
    this.bytes[this.length++] = DIGITS[byte >>> 4] ?? 0;
    this.bytes[this.length++] = DIGITS[byte & 0xf] ?? 0;
    return byte;
  }

  private makeRoom(more: number): void {
    if (this.length + more <= this.bytes.length) return;
    const larger = new Uint8Array(2 * (this.length + more));
    larger.set(this.bytes);
    this.bytes = larger;
  }
}
