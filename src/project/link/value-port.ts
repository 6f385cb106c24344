/** Receives values, each for its column. */
export interface ValueWriter {
  /** A whole number from 0 to 2³⁵ − 1; in the column `WORDS` a UTF-16 unit. */
  uint(column: number, value: number): void;
  /** @param near knowledge about the value, most general first; a writer may use it or not */
  int(column: number, value: number, near?: readonly number[]): void;
  /** Writes it as its difference from the previous one in its column. */
  delta(column: number, value: number): void;
  byte(column: number, value: number): void;
  /** The number of an earlier word, counted from 1; 0 for a new one. */
  known(word: string): number;
}

/** Gives values in the order in which they were written. Throws `DamagedBytes` where there cannot be one. */
export interface ValueReader {
  uint(column: number): number;
  int(column: number, near?: readonly number[]): number;
  delta(column: number): number;
  byte(column: number): number;
  /** Upper limit for the values that can follow in a column. */
  left(column: number): number;
  /** The word with a number of `ValueWriter.known`. */
  word(number: number): string;
  /** Notes a word that is new. */
  learn(word: string): void;
}
