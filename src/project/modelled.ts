import type { ValueReader, ValueWriter } from './values';
import { DamagedBytes, varintBytes, WORDS } from './columns';
import { RangeDecoder, RangeEncoder } from './range-coder';
import { ValueModel } from './value-model';
import { LIKELY_TEXT } from './words';

/**
 * The most that is written or read with a model, in bytes as columns would have them: a model takes about 5 µs a byte
 * on a laptop, so no link keeps a tablet busy for long. Chosen: sixteen times a drawing of 5,000 pen points.
 */
export const MODELLED_BYTES = 64 * 1024;

/** What is read would be more than `MODELLED_BYTES`. */
export class TooManyBytes extends Error {}

/** Writes values one after the other, each as so many bits as it is unlikely (`value-model.ts`). */
export class ModelWriter implements ValueWriter {
  private readonly coder = new RangeEncoder();
  private readonly model = new ValueModel((yes, bit) => {
    this.coder.encode(bit, yes);
    return bit;
  }, taughtModel());
  private readonly last: number[] = [];
  private readonly words = new Map<string, number>();

  uint(column: number, value: number, near?: readonly number[]): void {
    if (column === WORDS) this.model.unit(value);
    else this.model.uint(column, value, near);
  }

  int(column: number, value: number, near?: readonly number[]): void {
    this.uint(column, value < 0 ? -2 * value - 1 : 2 * value, near);
  }

  delta(column: number, value: number): void {
    this.int(column, value - (this.last[column] ?? 0));
    this.last[column] = value;
  }

  byte(column: number, value: number): void {
    this.uint(column, value);
  }

  known(word: string): number {
    const number = this.words.get(word) ?? 0;
    if (number === 0) this.words.set(word, this.words.size + 1);
    return number;
  }

  /** All that was written. */
  bytes(): Uint8Array {
    return this.coder.bytes();
  }
}

/** Reads what a `ModelWriter` wrote. Throws `DamagedBytes` for anything else, `TooManyBytes` when it does not end. */
export class ModelReader implements ValueReader {
  private readonly coder: RangeDecoder;
  private readonly model: ValueModel;
  private readonly last: number[] = [];
  private readonly words: string[] = [];
  private room = MODELLED_BYTES;

  constructor(bytes: Uint8Array) {
    this.coder = new RangeDecoder(bytes);
    this.model = new ValueModel((yes) => this.coder.decode(yes), taughtModel());
  }

  uint(column: number, near?: readonly number[]): number {
    const value = column === WORDS ? this.model.unit(0) : this.model.uint(column, 0, near);
    this.room -= varintBytes(value);
    if (this.room < 0) throw new TooManyBytes();
    return value;
  }

  int(column: number, near?: readonly number[]): number {
    const value = this.uint(column, near);
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  delta(column: number): number {
    const value = (this.last[column] ?? 0) + this.int(column);
    this.last[column] = value;
    return value;
  }

  byte(column: number): number {
    const value = this.uint(column);
    if (value > 0xff) throw new DamagedBytes();
    return value;
  }

  left(): number {
    return this.room;
  }

  word(number: number): string {
    const word = this.words[number - 1];
    if (word === undefined) throw new DamagedBytes();
    return word;
  }

  learn(word: string): void {
    this.words.push(word);
  }

  /** Whether everything was read. */
  get isAtEnd(): boolean {
    return this.coder.isAtEnd;
  }
}

/** A model that has read what is likely to be said; made once. */
function taughtModel(): ValueModel {
  if (taught !== null) return taught;
  taught = new ValueModel((_, bit) => bit);
  for (let index = 0; index < LIKELY_TEXT.length; index += 1) taught.unit(LIKELY_TEXT.charCodeAt(index));
  return taught;
}
let taught: ValueModel | null = null;
