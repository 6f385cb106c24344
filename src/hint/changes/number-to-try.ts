import { numbersOfLine } from '#python/numbers';
import { withChange, type Change } from './change';

/**
 * The number that a change turns, by the name that a sweep has for it: `main.py:5`, or `main.py:5.2` for the second of its
 * line. `null`: it turns none.
 *
 * @param program the text before the change
 */
export function numberToTry(change: Change, program: string): string | null {
  if (change.kind !== 'number') return null;
  const { line } = change;
  const [before, after] = [program, withChange(program, change)].map((text) => numbersOfLine(text, line));
  const place = (before ?? []).findIndex(({ text }, at) => text !== after?.[at]?.text);
  if (before === undefined || place < 0) return null;
  return before.length === 1 ? `main.py:${String(line)}` : `main.py:${String(line)}.${String(place + 1)}`;
}
