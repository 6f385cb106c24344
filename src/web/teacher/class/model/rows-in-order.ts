import { nameOrder } from '#check/report/names';
import type { RemarkCode } from '#check/result';

import type { Row } from './class-model';

/** State of a hand-in. */
export type RowState = 'waiting' | 'passed' | 'failed' | 'unread';

export const stateOf = ({ result }: Row): RowState => {
  if (result === null) return 'waiting';
  if (result.remarks.some(({ code }) => code === 'unreadable')) return 'unread';
  return result.passed ? 'passed' : 'failed';
};

/** Remarks that a teacher should look at; an untouched program is none of them. */
const TELLING: readonly RemarkCode[] = ['hand', 'outside', 'course', 'unlocked', 'verdict', 'hash', 'no-hash', 'edited', 'twins', 'other-task', 'unreadable']; // prettier-ignore

/** True if something about a hand-in should be looked at. */
export const isToLookAt = ({ result }: Row): boolean =>
  result?.remarks.some(({ code }) => TELLING.includes(code)) === true;

/** The hand-ins that the table can show; `look`: those with remarks to look at. */
export const filters = ['all', 'passed', 'failed', 'unread', 'look'] as const;
export type Filter = (typeof filters)[number];

/** Columns by which they can be put in order. */
export const sortable = ['name', 'result', 'worlds', 'time', 'touches', 'points'] as const;
export type Column = (typeof sortable)[number];

export interface Order {
  readonly by: Column;
  readonly isDown: boolean;
}

/** Simulated ms until the visible world was decided; `null`: it was not. */
export const timeOf = ({ result }: Row): number | null => result?.worlds[0]?.atMs ?? null;

/** Touches in all worlds together. */
export const touchesOf = ({ result }: Row): number =>
  result?.worlds.reduce((sum, { touches }) => sum + touches, 0) ?? 0;

/** Number of worlds that were passed. */
export const worldsPassed = ({ result }: Row): number => result?.worlds.filter(({ passed }) => passed).length ?? 0;

const STATES: readonly RowState[] = ['passed', 'failed', 'unread', 'waiting'];

/** The sort key of a column; the smallest is first. */
const keys: Readonly<Record<Exclude<Column, 'name'>, (row: Row) => number>> = {
  result: (row) => STATES.indexOf(stateOf(row)),
  worlds: (row) => -worldsPassed(row),
  // What never came to an end comes last.
  time: (row) => timeOf(row) ?? Infinity,
  touches: touchesOf,
  points: ({ result, marked }) => -(marked ?? result?.points ?? -1),
};

/** The hand-ins that pass a filter, in an order; those that are equal are in the order of their names. */
export function inOrder(rows: readonly Row[], filter: Filter, { by, isDown }: Order, language: string): readonly Row[] {
  const compare = nameOrder(language);
  const byName = (a: Row, b: Row): number => compare(a.shown, b.shown);
  const key = by === 'name' ? null : keys[by];
  const sign = isDown ? -1 : 1;
  return rows
    .filter((row) => passes(row, filter))
    .toSorted((a, b) => {
      const [one, other] = key === null ? [0, 0] : [key(a), key(b)];
      return one === other ? (key === null ? sign : 1) * byName(a, b) : sign * (one < other ? -1 : 1);
    });
}

function passes(row: Row, filter: Filter): boolean {
  if (filter === 'all') return true;
  if (filter === 'look') return isToLookAt(row);
  return stateOf(row) === filter;
}
