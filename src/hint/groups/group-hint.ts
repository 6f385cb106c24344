import { check } from '#check/check';
import type { HandIn } from '#check/hand-in/hand-in';
import { visibleTask } from '#check/task/visible';
import type { ClassTask } from '#check/task/task';
import { numbersIn, withNumber } from '#python/numbers';
import { linesOf, withChange, type Change } from '../changes/change';
import { changedNumber } from '../changes/number-to-try';
import { hintFor, type Hint, type Hinter } from '../hint';
import { mainOf } from '../main-of';
import { withMain } from '../trials';

/** The hint to a group: that to its example, and how far it holds. */
export interface GroupHint {
  readonly hint: Hint;
  /**
   * For each hand-in the change with which its program passes, proved by running it, the example's first; `null`: it does
   * not with the same.
   */
  readonly changes: readonly (Change | null)[];
  /** Number of the group's hand-ins that pass with the same change. */
  readonly holds: number;
  readonly of: number;
}

/** The most places of another program at which the change is tried. Chosen: the same line seldom stands there more often. */
const MOST_PLACES = 3;

/**
 * Finds the hint to the example of a group, and tries the same change in the others' programs, each at the places that look alike.
 *
 * @param handIns the example first
 * @returns `null`: the example passes
 */
export async function groupHint(
  task: ClassTask,
  handIns: readonly HandIn[],
  hinter: Hinter,
): Promise<GroupHint | null> {
  // prettier-ignore
  const [example, ...others] = handIns;
  const hint = example === undefined ? null : await hintFor(task, example, hinter);
  if (example === undefined || hint === null) return null;
  const changes = [hint.change];
  for (const other of others)
    changes.push(hint.change && (await changeOf(hint.change, mainOf(example), task, other, hinter)));
  return { hint, changes, holds: changes.filter((change) => change !== null).length, of: handIns.length };
}

/** The same change in another program, if that passes with it. */
async function changeOf(
  change: Change,
  program: string,
  task: ClassTask,
  other: HandIn,
  { firmware, beat = () => undefined }: Hinter,
): Promise<Change | null> {
  // prettier-ignore
  for (const there of likewise(change, program, mainOf(other)).slice(0, MOST_PLACES)) {
    const changed = withMain(other, withChange(mainOf(other), there));
    if ((await check(visibleTask(task), changed, { firmware, beat })).passed) return there;
  }
  return null;
}

/**
 * The same change at the places of another program that look like that of the first: those nearest to the same line come first.
 * Numbers may be other ones there: only the one that is changed becomes that of the change.
 */
export function likewise(change: Change, program: string, other: string): readonly Change[] {
  const [own, lines] = [linesOf(program), linesOf(other)];
  const plain = (line = ''): string => {
    const code = line.replace(/\s*#.*$/, '').trim();
    if (change.kind !== 'number') return code;
    // Names are taken whole: the digits in them are no numbers.
    return code.replace(/[\p{L}_][\p{L}\p{N}_]*|\d+(\.\d+)?/gu, (found) => (/^\d/.test(found) ? '0' : found));
  };
  const isInsertion = change.before.length === 0;
  const wanted = isInsertion ? [own[change.line - 2], own[change.line - 1]] : change.before;
  const shift = isInsertion ? 1 : 0;
  const places = lines.flatMap((_, at) =>
    wanted.every((line, place) => plain(lines[at + place - shift]) === plain(line)) ? [at] : [],
  );
  const from = change.line - 1;
  const inOrder = places.toSorted((one, another) => Math.abs(one - from) - Math.abs(another - from) || one - another);
  if (change.kind === 'number') return withNumberOf(change, program, other, inOrder);
  return inOrder.map((at) => {
    const indent = indentOf(lines[at]) - indentOf(own[from]);
    return {
      ...change,
      line: at + 1,
      before: lines.slice(at, at + change.before.length),
      after: change.after.map((line) => moved(line, indent)),
    };
  });
}

/** The changes of one number of another program's lines to that of a change: greater or less as seen from the one there. */
function withNumberOf(change: Change, program: string, other: string, places: readonly number[]): readonly Change[] {
  const turned = changedNumber(change, program);
  const numbers = turned === null ? [] : numbersIn(other);
  return places.flatMap((at): readonly Change[] => {
    const here = numbers.filter(({ line }) => line === at + 1);
    const number = turned === null || here.length !== turned.of ? undefined : here[turned.place];
    if (turned === null || number === undefined || turned.value === number.value) return [];
    const after = linesOf(withNumber(other, number, turned.value))[at] ?? '';
    const direction = turned.value > number.value ? 'more' : 'less';
    return [{ ...change, line: at + 1, before: linesOf(other).slice(at, at + 1), after: [after], direction }];
  });
}

const indentOf = (line = ''): number => /^ */.exec(line)?.[0].length ?? 0;

const moved = (line: string, by: number): string => (by >= 0 ? ' '.repeat(by) + line : line.slice(Math.min(-by, indentOf(line)))); // prettier-ignore
