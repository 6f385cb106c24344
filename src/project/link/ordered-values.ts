import { DamagedBytes } from './damaged-bytes';
import type { ValueReader, ValueWriter } from './value-port';

/** Common to all writers of whole numbers: signs, differences and words become numbers from 0. */
export abstract class OrderedWriter implements ValueWriter {
  private readonly last: number[] = [];
  private readonly words = new Map<string, number>();

  abstract uint(column: number, value: number, near?: readonly number[]): void;
  abstract byte(column: number, value: number): void;

  /** A whole number of either sign: 0, −1, 1, −2, 2, … are 0, 1, 2, 3, 4, … */
  int(column: number, value: number, near?: readonly number[]): void {
    this.uint(column, value < 0 ? -2 * value - 1 : 2 * value, near);
  }

  /** A whole number as its difference from the previous one in its column. */
  delta(column: number, value: number): void {
    this.int(column, value - (this.last[column] ?? 0));
    this.last[column] = value;
  }

  /** The number of an earlier word, counted from 1; 0 for a new one. */
  known(word: string): number {
    const number = this.words.get(word) ?? 0;
    if (number === 0) this.words.set(word, this.words.size + 1);
    return number;
  }
}

/** Common to all readers: numbers from 0 become signs, differences and words again. */
export abstract class OrderedReader implements ValueReader {
  private readonly last: number[] = [];
  private readonly words: string[] = [];

  abstract uint(column: number, near?: readonly number[]): number;
  abstract byte(column: number): number;
  abstract left(column: number): number;

  int(column: number, near?: readonly number[]): number {
    const value = this.uint(column, near);
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  delta(column: number): number {
    const value = (this.last[column] ?? 0) + this.int(column);
    this.last[column] = value;
    return value;
  }

  word(number: number): string {
    const word = this.words[number - 1];
    if (word === undefined) throw new DamagedBytes();
    return word;
  }

  learn(word: string): void {
    this.words.push(word);
  }
}
