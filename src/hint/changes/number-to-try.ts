import { numbersOfLine } from '#python/numbers';
import { withChange, type Change } from './change';

/** The number that a change turns. */
export interface ChangedNumber {
  /** Its place among the numbers of its line, from 0. */
  readonly place: number;
  /** Number of the numbers of its line. */
  readonly of: number;
  /** Its value after the change. */
  readonly value: number;
}

/**
 * The number that a change turns; `null`: it turns none.
 *
 * @param program the text before the change
 */
export function changedNumber(change: Change, program: string): ChangedNumber | null {
  if (change.kind !== 'number') return null;
  const { line } = change;
  const [before = [], after = []] = [program, withChange(program, change)].map((text) => numbersOfLine(text, line));
  const place = before.findIndex(({ text }, at) => text !== after[at]?.text);
  const turned = after[place];
  return turned === undefined ? null : { place, of: before.length, value: turned.value };
}

/**
 * The number that a change turns, by the name that a sweep has for it: `main.py:5`, or `main.py:5.2` for the second of its
 * line. `null`: it turns none.
 *
 * @param program the text before the change
 */
export function numberToTry(change: Change, program: string): string | null {
  const turned = changedNumber(change, program);
  if (turned === null) return null;
  const { line } = change;
  return turned.of === 1 ? `main.py:${String(line)}` : `main.py:${String(line)}.${String(turned.place + 1)}`;
}
