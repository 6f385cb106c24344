/** Where values are written, each into its column. */
export interface ValueWriter {
  /** A whole number from 0 to 2³⁵ − 1; a UTF-16 unit where the column is `WORDS`. */
  uint(column: number, value: number): void;
  /** @param near what is known about the value, most general first; a writer may make use of it or not */
  int(column: number, value: number, near?: readonly number[]): void;
  /** As its difference from the one before in its column. */
  delta(column: number, value: number): void;
  byte(column: number, value: number): void;
  /** The number of a word that was there before, counted from 1; 0 for a new one. */
  known(word: string): number;
}

/** Where values are read, in the order in which they were written. Throws `DamagedBytes` where none can be. */
export interface ValueReader {
  uint(column: number): number;
  int(column: number, near?: readonly number[]): number;
  delta(column: number): number;
  byte(column: number): number;
  /** More values than this cannot follow in a column. */
  left(column: number): number;
  /** The word with a number of `ValueWriter.known`. */
  word(number: number): string;
  /** Notes a word that is new. */
  learn(word: string): void;
}
