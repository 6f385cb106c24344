// What the language of the oldest browsers (ES2022, `scripts/oldest.mjs`) lacks, and `src/web/kit/oldest/` fills in.

interface ReadonlyArray<T> {
  findLast<S extends T>(test: (value: T, index: number, row: readonly T[]) => value is S): S | undefined;
  findLast(test: (value: T, index: number, row: readonly T[]) => unknown): T | undefined;
  findLastIndex(test: (value: T, index: number, row: readonly T[]) => unknown): number;
  toReversed(): T[];
  toSorted(compare?: (a: T, b: T) => number): T[];
  toSpliced(start: number, count: number, ...added: T[]): T[];
  with(index: number, value: T): T[];
}

interface Array<T> {
  findLast<S extends T>(test: (value: T, index: number, row: T[]) => value is S): S | undefined;
  findLast(test: (value: T, index: number, row: T[]) => unknown): T | undefined;
  findLastIndex(test: (value: T, index: number, row: T[]) => unknown): number;
  toReversed(): T[];
  toSorted(compare?: (a: T, b: T) => number): T[];
  toSpliced(start: number, count: number, ...added: T[]): T[];
  with(index: number, value: T): T[];
}

interface Float64Array {
  findLastIndex(test: (value: number, index: number, row: this) => unknown): number;
}
