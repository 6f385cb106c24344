import { packed, unpacked } from '#core/deflate';
import { isSame } from '#core/same';
import { ByteReader, ByteWriter } from './bytes';
import { ABSENT, leafOf } from './codes';
import { putLeaf, type Column, type Key, type Leaf } from './leaves';

/** The codes of one column at successive moments: `ABSENT` before it was first seen. */
export type Series = readonly number[];

/** The content of one piece of a tape. */
export interface ChunkContent {
  /** True if it needs none of the pieces before it: its columns and values are all there are. */
  readonly isFirst: boolean;
  /** Columns and values that no earlier piece contains. */
  readonly newColumns: readonly Column[];
  readonly newValues: readonly Leaf[];
  /** Number of moments. */
  readonly moments: number;
  /** The codes of every column known so far, one for each moment. */
  readonly columns: readonly Series[];
}

/** The ways in which the codes of a column are written. */
const WAYS = { constant: 0, changes: 1, motion: 2 } as const;

/** A chunk unpacks to no more than this; a longer one is damaged. Chosen: 500 moments of 2,000 changing columns. */
const MOST_BYTES = 8_000_000;

/** Writes a piece as bytes. */
export function writeChunk({ isFirst, newColumns, newValues, moments, columns }: ChunkContent): Uint8Array {
  const out = new ByteWriter();
  const told = newColumns.map(({ path, step }) => [path, Math.round(1 / step)]);
  out.text(JSON.stringify([isFirst, told, newValues]));
  out.uint(moments);
  out.uint(columns.length);
  for (const codes of columns) writeColumn(out, codes);
  return packed(out.bytes());
}

/**
 * A column in the shorter of its ways: only where it changes, or, where most moments differ, how much its change differs
 * from the change before. What moves steadily is then a row of zeros.
 */
function writeColumn(out: ByteWriter, codes: Series): void {
  const changes = codes.reduce((sum, code, at) => sum + Number(at > 0 && code !== codes[at - 1]), 0);
  const way = changes === 0 ? WAYS.constant : changes * 2 < codes.length ? WAYS.changes : WAYS.motion;
  out.uint(way);
  out.int(codes[0] ?? ABSENT);
  if (way === WAYS.changes) writeChanges(out, codes, changes);
  else if (way === WAYS.motion) writeMotion(out, codes);
}

function writeChanges(out: ByteWriter, codes: Series, changes: number): void {
  out.uint(changes);
  let last = 0;
  for (let at = 1; at < codes.length; at++) {
    const step = (codes[at] ?? 0) - (codes[at - 1] ?? 0);
    if (step === 0) continue;
    out.uint(at - last);
    out.int(step);
    last = at;
  }
}

function writeMotion(out: ByteWriter, codes: Series): void {
  let before = 0;
  for (let at = 1; at < codes.length; at++) {
    const step = (codes[at] ?? 0) - (codes[at - 1] ?? 0);
    out.int(step - before);
    before = step;
  }
}

/** A piece that was read: any of its moments can be made again. */
export interface Chunk {
  /** True if it needs none of the pieces before it. */
  readonly isFirst: boolean;
  readonly moments: number;
  /** All columns and values up to this piece. */
  readonly columns: readonly Column[];
  readonly values: readonly Leaf[];
  readonly codes: readonly Series[];
}

/** The content of the pieces before a piece. */
export interface KnownContent {
  readonly columns: readonly Column[];
  readonly values: readonly Leaf[];
}

/** The content before the first piece. */
export const NOTHING_KNOWN: KnownContent = { columns: [], values: [] };

/** Reads a piece; `null` if the bytes are none. */
export function readChunk(bytes: Uint8Array, before: KnownContent): Chunk | null {
  const plain = unpacked(bytes, MOST_BYTES);
  if (typeof plain === 'string') return null;
  const from = new ByteReader(plain);
  const head = headOf(from.text());
  if (head === null) return null;
  const { isFirst } = head;
  const known = isFirst ? NOTHING_KNOWN : before;
  // Most pieces tell nothing new: then the lists are the same ones.
  const columns = head.columns.length === 0 ? known.columns : [...known.columns, ...head.columns];
  const values = head.values.length === 0 ? known.values : [...known.values, ...head.values];
  const moments = from.uint();
  if (from.uint() !== columns.length || moments > MOST_BYTES) return null;
  const codes = columns.map(() => readColumn(from, moments));
  if (!from.isGood) return null;
  return { isFirst, moments, columns, values, codes };
}

function headOf(text: string): (KnownContent & Pick<Chunk, 'isFirst'>) | null {
  try {
    const [isFirst, columns, values] = JSON.parse(text) as [boolean, [Key[], number][], Leaf[]];
    return { isFirst, columns: columns.map(([path, perUnit]) => ({ path, step: 1 / perUnit })), values };
  } catch {
    return null;
  }
}

function readColumn(from: ByteReader, moments: number): Series {
  const way = from.uint();
  const codes = new Array<number>(from.isGood ? moments : 0).fill(from.int());
  if (way === WAYS.changes) readChanges(from, codes);
  else if (way === WAYS.motion) readMotion(from, codes);
  return codes;
}

function readChanges(from: ByteReader, codes: number[]): void {
  let at = 0;
  for (let changes = from.uint(); changes > 0 && from.isGood; changes--) {
    const since = at;
    at += from.uint();
    const code = (codes[since] ?? 0) + from.int();
    codes.fill(code, at);
  }
}

function readMotion(from: ByteReader, codes: number[]): void {
  let step = 0;
  for (let at = 1; at < codes.length && from.isGood; at++) {
    step += from.int();
    codes[at] = (codes[at - 1] ?? 0) + step;
  }
}

/** The data of one moment of a piece. */
export function dataOfMoment({ columns, values, codes }: Chunk, moment: number): unknown {
  const root: { value: unknown } = { value: undefined };
  for (const [index, { path, step }] of columns.entries()) {
    const leaf = leafOf(codes[index]?.[moment] ?? ABSENT, step, values);
    if (leaf !== undefined) putLeaf(root, path, leaf);
  }
  return root.value;
}

/** The times of a piece's moments in µs; `null` for a piece that has none. */
export function timesOf({ columns, codes }: Chunk): readonly number[] | null {
  const at = columns.findIndex(({ path }) => path.length === 1 && path[0] === 'timeUs');
  return codes[at]?.map((code) => code / 2) ?? null;
}

/** The values at one path, one for each of a piece's moments or `undefined`; empty if the piece lacks the path. */
export function leavesAt({ columns, values, codes }: Chunk, path: readonly Key[]): readonly (Leaf | undefined)[] {
  const at = columns.findIndex((column) => isSame(column.path, path));
  return codes[at]?.map((code) => leafOf(code, columns[at]?.step ?? 1, values)) ?? [];
}
