/**
 * Bytes in columns: all values of one kind stand together (all x, all y, all widths …), because similar values pack
 * best. A whole number is written as a varint: seven bits a byte, the lowest first, the top bit says that more follow.
 * The words stand apart from the figures: they pack with other tables.
 *
 *     figures: count of columns · length of each column · the columns (column 1, 2, …)
 *     words:   column 0
 */

import { DamagedBytes } from './damaged-bytes';
import { OrderedReader, OrderedWriter } from './ordered-values';

/** The column of all words. */
export const WORDS = 0;

/** The output of a `ColumnWriter`. */
export interface Bytes {
  readonly figures: Uint8Array;
  readonly words: Uint8Array;
}

/** Longest varint: 5 bytes hold 35 bits, far more than any coordinate or length. */
export const VARINT_BYTES = 5;
const VARINT_END = 34_359_738_368; // 2³⁵

/** Writes values into columns. */
export class ColumnWriter extends OrderedWriter {
  private readonly columns: number[][] = [[]];

  /** A whole number from 0 to 2³⁵ − 1. */
  uint(column: number, value: number): void {
    push(this.column(column), value);
  }

  byte(column: number, value: number): void {
    this.column(column).push(value);
  }

  /** Everything that was written. */
  bytes(): Bytes {
    const [words = [], ...columns] = this.columns;
    const head: number[] = [];
    push(head, columns.length);
    for (const column of columns) push(head, column.length);
    const figures = new Uint8Array(columns.reduce((sum, column) => sum + column.length, head.length));
    let at = 0;
    for (const part of [head, ...columns]) {
      figures.set(part, at);
      at += part.length;
    }
    return { figures, words: Uint8Array.from(words) };
  }

  private column(index: number): number[] {
    while (this.columns.length <= index) this.columns.push([]);
    return this.columns[index] ?? [];
  }
}

function push(to: number[], value: number): void {
  if (!Number.isInteger(value) || value < 0 || value >= VARINT_END)
    throw new RangeError(`not a varint: ${String(value)}`);
  let rest = value;
  while (rest >= 0x80) {
    to.push((rest % 0x80) + 0x80);
    rest = Math.floor(rest / 0x80);
  }
  to.push(rest);
}

/** Number of bytes of a whole number from 0 as a varint. */
export function varintBytes(value: number): number {
  let bytes = 1;
  for (let rest = value; rest >= 0x80; rest = Math.floor(rest / 0x80)) bytes += 1;
  return bytes;
}

/** A column that is being read. */
interface Column {
  readonly bytes: Uint8Array;
  at: number;
  readonly end: number;
}

/** Reads what a `ColumnWriter` wrote, in the same order. Throws `DamagedBytes` for anything else. */
export class ColumnReader extends OrderedReader {
  private readonly columns: readonly Column[];

  /** @param columns the maximum number, including the words */
  constructor({ figures, words }: Bytes, columns: number) {
    super();
    const head: Column = { bytes: figures, at: 0, end: figures.length };
    const count = uintOf(head);
    if (count >= columns) throw new DamagedBytes();
    const lengths = Array.from({ length: count }, () => uintOf(head));
    let start = head.at;
    const read = lengths.map((length): Column => {
      const at = start;
      start += length;
      return { bytes: figures, at, end: start };
    });
    if (start !== figures.length) throw new DamagedBytes();
    this.columns = [{ bytes: words, at: 0, end: words.length }, ...read];
  }

  uint(column: number): number {
    return uintOf(this.column(column));
  }

  byte(column: number): number {
    return byteOf(this.column(column));
  }

  /** Bytes left in a column: nothing that is counted can exceed that. */
  left(column: number): number {
    const of = this.column(column);
    return of.end - of.at;
  }

  /** True if everything was read. */
  get isAtEnd(): boolean {
    return this.columns.every(({ at, end }) => at === end);
  }

  private column(index: number): Column {
    const column = this.columns[index];
    if (column === undefined) throw new DamagedBytes();
    return column;
  }
}

function uintOf(column: Column): number {
  let value = 0;
  let unit = 1;
  for (let index = 0; index < VARINT_BYTES; index += 1) {
    const byte = byteOf(column);
    value += (byte & 0x7f) * unit;
    if (byte < 0x80) return value;
    unit *= 0x80;
  }
  throw new DamagedBytes();
}

function byteOf(column: Column): number {
  const byte = column.at < column.end ? column.bytes[column.at] : undefined;
  if (byte === undefined) throw new DamagedBytes();
  column.at += 1;
  return byte;
}
