/** Writes whole numbers up to 2⁵³ as seven bits a byte, the lowest first; the top bit says that more follow. */
export class ByteWriter {
  private readonly out: number[] = [];

  /** From 0 on. */
  uint(value: number): void {
    let rest = value;
    while (rest >= 128) {
      this.out.push((rest % 128) + 128);
      rest = Math.floor(rest / 128);
    }
    this.out.push(rest);
  }

  /** Small ones of either sign are short: 0, −1, 1, −2 … are written as 0, 1, 2, 3 … */
  int(value: number): void {
    this.uint(value < 0 ? -2 * value - 1 : 2 * value);
  }

  text(text: string): void {
    const bytes = new TextEncoder().encode(text);
    this.uint(bytes.length);
    for (const byte of bytes) this.out.push(byte);
  }

  bytes(): Uint8Array {
    return Uint8Array.from(this.out);
  }
}

/** Reads what `ByteWriter` wrote. Past the end, or where a number is too long, everything is 0 and `isGood` is false. */
export class ByteReader {
  isGood = true;
  private at = 0;

  constructor(private readonly from: Uint8Array) {}

  uint(): number {
    let value = 0;
    for (let scale = 1; this.at < this.from.length && scale <= HIGHEST; scale *= 128) {
      const byte = this.from[this.at++] ?? 0;
      value += (byte % 128) * scale;
      if (byte < 128) return value;
    }
    this.isGood = false;
    return 0;
  }

  int(): number {
    const value = this.uint();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  text(): string {
    const length = this.uint();
    const bytes = this.from.subarray(this.at, this.at + length);
    this.isGood &&= bytes.length === length;
    this.at += length;
    return new TextDecoder().decode(bytes);
  }
}

/** 128⁷: the eighth byte of a number below 2⁵³ or a little more. */
const HIGHEST = 562_949_953_421_312;
