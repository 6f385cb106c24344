import { argumentsOf } from '#python/expressions';
import { textOf, type PythonText, type SyntaxNode } from '#python/tree';

/** Numbers that were written with a comma, and how they should be written. */
export interface DecimalComma {
  /** The first of them, with a point: `0.2`. */
  readonly code: string;
  readonly change: { readonly from: number; readonly to: number; readonly insert: string };
}

/** A whole number and the next one, which could be its decimals, with the gap between them. */
interface Pair {
  readonly start: number;
  readonly from: number;
  readonly to: number;
  readonly end: number;
}

/**
 * Numbers with a decimal comma in a call that got more values than it takes: `leftArc(0,2)`. `null` where the values may
 * be meant one by one.
 *
 * @param takes true for a number of values that the function takes
 */
export function decimalComma(
  program: PythonText,
  call: SyntaxNode,
  takes: (given: number) => boolean,
): DecimalComma | null {
  const values = argumentsOf(program, call).map(({ value }) => value);
  if (takes(values.length)) return null;
  const pairs = values.slice(1).flatMap((after, index) => pairOf(program, values[index] ?? null, after));
  const [first, last] = [pairs[0], pairs.at(-1)];
  if (first === undefined || last === undefined || !isApart(pairs) || !takes(values.length - pairs.length)) return null;
  const { text } = program;
  const insert = pairs.map(({ from }, index) => text.slice(pairs[index - 1]?.to ?? first.start, from)).join('.');
  return {
    code: `${text.slice(first.start, first.from)}.${text.slice(first.to, first.end)}`,
    change: { from: first.start, to: last.end, insert: `${insert}.${text.slice(last.to, last.end)}` },
  };
}

function pairOf(program: PythonText, before: SyntaxNode | null, after: SyntaxNode | null): readonly Pair[] {
  if (before === null || after === null || after.from - before.to > 1) return []; // with a gap they are two values
  if (!/^-?\d+$/.test(textOf(program, before)) || !/^\d+$/.test(textOf(program, after))) return [];
  return [{ start: before.from, from: before.to, to: after.from, end: after.to }];
}

/** True if no number is in two pairs: `1,2,3` could be 1.2 and 3, or 1 and 2.3. */
const isApart = (pairs: readonly Pair[]): boolean =>
  pairs.every(({ start }, index) => start >= (pairs[index - 1]?.end ?? 0));
