import type { Day } from '#core/day';
import { gradeOf } from './grades';
import type { Pupil, Result, SchoolClass, SetTask } from './school-class';

/** The standing of a pupil in a task. The best result counts, of equal ones the newest. */
export interface Cell {
  /**
   * `partly`: not passed, with points. `unread`: handed in, and nothing of it could be read. `missing`: nothing was handed in,
   * and the last day is over, or there is none. `open`: nothing yet, and there is time.
   */
  readonly state: 'passed' | 'partly' | 'failed' | 'unread' | 'missing' | 'open';
  readonly points: number;
  /** `null`: none. */
  readonly stars: number | null;
  /** Number of different hand-ins. */
  readonly tries: number;
  /** The result that counts; `null`: there is none. */
  readonly result: Result | null;
}

/** The row of a pupil. */
export interface Row {
  readonly pupil: Pupil;
  /** A cell for each task of the class, in their order. */
  readonly cells: readonly Cell[];
  /** Points of all that counts: what is open or could not be read does not. */
  readonly points: number;
  /** Points that could be had in it. */
  readonly most: number;
  /** `null`: the class has no scale, or nothing counts yet. */
  readonly grade: number | null;
}

/** The table of a class on a day: a row for each pupil. */
export function rowsOf(schoolClass: SchoolClass, day: Day): readonly Row[] {
  const { pupils, tasks, scale } = schoolClass;
  const results = byPupilAndTask(schoolClass);
  return pupils.map((pupil) => {
    const cells = tasks.map((task) => cellOf(task, results.get(keyOf(pupil.id, task.id)) ?? [], day));
    const counted = cells.map(({ state }) => state !== 'open' && state !== 'unread');
    const sum = cells.reduce((so, cell, place) => (counted[place] === true ? so + cell.points : so), 0);
    const points = Math.round(sum * 100) / 100; // those set by hand have decimals
    const most = tasks.reduce((sum, task, place) => (counted[place] === true ? sum + task.points : sum), 0);
    return { pupil, cells, points, most, grade: scale && gradeOf(scale, points, most) };
  });
}

/** Ids have no line breaks where they come from; in a file they might, and then rows would only share a key. */
const keyOf = (pupil: string, task: string): string => JSON.stringify([pupil, task]);

function byPupilAndTask({ results }: SchoolClass): ReadonlyMap<string, readonly Result[]> {
  const found = new Map<string, Result[]>();
  for (const result of results) {
    const key = keyOf(result.pupil, result.task);
    const others = found.get(key);
    if (others === undefined) found.set(key, [result]);
    else others.push(result);
  }
  return found;
}

function cellOf({ due }: SetTask, results: readonly Result[], day: Day): Cell {
  const best = results.reduce<Result | null>(
    (one, other) => (one === null || !isBetter(one, other) ? other : one),
    null,
  );
  if (best === null) {
    const state = due !== null && day <= due ? 'open' : 'missing';
    return { state, points: 0, stars: null, tries: 0, result: null };
  }
  const { outcome, stars } = best;
  const points = countedIn(best);
  const state = outcome === 'failed' && points > 0 ? 'partly' : outcome;
  return { state, points, stars, tries: results.length, result: best };
}

/** The points of a result that count. */
const countedIn = ({ points, marked }: Result): number => marked ?? points;

const RANKS = { passed: 2, failed: 1, unread: 0 } as const;

/** True if the first of two results is the better one. */
function isBetter(one: Result, other: Result): boolean {
  const figures = (result: Result): readonly number[] => [RANKS[result.outcome], countedIn(result), result.stars ?? 0];
  const [own, theirs] = [figures(one), figures(other)];
  const at = own.findIndex((figure, place) => figure !== theirs[place]);
  return at >= 0 && (own[at] ?? 0) > (theirs[at] ?? 0);
}

/** Those who have not handed in a task. */
export const missingIn = (rows: readonly Row[], place: number): readonly Pupil[] =>
  rows.filter(({ cells }) => ['missing', 'open'].includes(cells[place]?.state ?? '')).map(({ pupil }) => pupil);
