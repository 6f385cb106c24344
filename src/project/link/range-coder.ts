/**
 * An arithmetic coder for yes and no: a likely decision takes far less than a bit. Both sides hold the same interval of
 * 32-bit numbers; each decision keeps the part of it that its probability gives, and leading bytes that low and high
 * end have in common are written out.
 */
import { DamagedBytes } from './damaged-bytes';

/** A probability of yes as a whole number from 1 to `CERTAIN` − 1. */
export const CERTAIN = 65_536;

/** The last number of the lower part (yes). Both ends differ in their first byte, so either part has room. */
const splitOf = (low: number, high: number, yes: number): number => low + Math.floor(((high - low) * yes) / CERTAIN);

/** Writes decisions. */
export class RangeEncoder {
  private readonly written: number[] = [];
  private low = 0;
  private high = 0xffffffff;

  /** @param yes the probability that `bit` is 1, in parts of `CERTAIN` */
  encode(bit: number, yes: number): void {
    const split = splitOf(this.low, this.high, yes);
    if (bit === 1) this.high = split;
    else this.low = split + 1;
    while ((this.low ^ this.high) >>> 24 === 0) {
      this.written.push(this.high >>> 24);
      this.low = (this.low << 8) >>> 0;
      this.high = ((this.high << 8) | 0xff) >>> 0;
    }
  }

  /** Everything that was encoded. Zeros are assumed to follow, so one more byte marks the end in the interval. */
  bytes(): Uint8Array {
    return Uint8Array.from([...this.written, (this.low >>> 24) + 1]);
  }
}

/** Zeros that a reader sees after the end when everything was read: it looks four bytes ahead. */
const BEYOND = 3;

/** Reads decisions in the order in which they were written, with the same probabilities. */
export class RangeDecoder {
  private low = 0;
  private high = 0xffffffff;
  private code = 0;
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {
    for (let byte = 0; byte < 4; byte += 1) this.shift();
  }

  /** @throws DamagedBytes after the end */
  decode(yes: number): number {
    const split = splitOf(this.low, this.high, yes);
    const bit = this.code <= split ? 1 : 0;
    if (bit === 1) this.high = split;
    else this.low = split + 1;
    while ((this.low ^ this.high) >>> 24 === 0) {
      this.low = (this.low << 8) >>> 0;
      this.high = ((this.high << 8) | 0xff) >>> 0;
      this.shift();
    }
    return bit;
  }

  /** True if exactly the existing bytes were read. */
  get isAtEnd(): boolean {
    return this.at === this.bytes.length + BEYOND;
  }

  private shift(): void {
    if (this.at >= this.bytes.length + BEYOND + 1) throw new DamagedBytes();
    this.code = ((this.code << 8) | (this.bytes[this.at] ?? 0)) >>> 0;
    this.at += 1;
  }
}
