import type { Language } from '#core/languages';
import type { CheckResult, Remark } from '../result';
import { nameOrder, shownNames } from './names';

/** Result of one person's hand-in. */
export interface NamedResult {
  /** Unlike the others; as the file, folder or link has it. */
  readonly name: string;
  /** The name as people read it, without what a platform adds; left out: as it is. */
  readonly shown?: string;
  readonly result: CheckResult;
  /** The teacher's note on it; left out: none. */
  readonly note?: string;
  /** Points that the teacher has set by hand; left out: those of the checks count. */
  readonly marked?: number;
}

/** Results of a class. */
export interface ClassResult {
  /** Name of the task. */
  readonly task: string;
  /** In the order of their shown names. */
  readonly handIns: readonly NamedResult[];
}

/** A result, and the points that the teacher has set by hand. */
export interface Counted {
  readonly result: CheckResult;
  readonly marked?: number | undefined;
}

/** The points that count: those set by hand, else those of the checks. */
export const countedPoints = ({ result, marked }: Counted): number => marked ?? result.points;

/** The name of a hand-in as people read it. */
export const shownName = ({ name, shown }: Pick<NamedResult, 'name' | 'shown'>): string => shown ?? name;

/**
 * Puts the results of a class together, in the order of their names in a language: those with the same program are marked.
 *
 * @param given in the order in which they were handed in
 */
export function classResult(task: string, given: readonly NamedResult[], language: Language): ClassResult {
  const order = nameOrder(language);
  const handIns = withShown(given).toSorted((one, other) => order(shownName(one), shownName(other)));
  const byTwin = new Map<string, string[]>();
  for (const one of handIns)
    if (one.result.twin !== '') byTwin.set(one.result.twin, [...(byTwin.get(one.result.twin) ?? []), shownName(one)]);
  return {
    task,
    handIns: handIns.map((one) => {
      const { result } = one;
      const names = (byTwin.get(result.twin) ?? []).filter((other) => other !== shownName(one));
      return names.length === 0 ? one : { ...one, result: withRemark(result, twins(names)) };
    }),
  };
}

/** Hand-ins with their shown names. */
function withShown(given: readonly NamedResult[]): readonly NamedResult[] {
  const shown = shownNames(given.map(({ name }) => name));
  return given.map((one, place) => (shown[place] === one.name ? one : { shown: shown[place] ?? one.name, ...one }));
}

/** Number of hand-ins that have passed. */
export const passedOf = ({ handIns }: ClassResult): number => handIns.filter(({ result }) => result.passed).length;

/** A task that is not the one of the class, and how many hand-ins were made for it. */
export interface OtherTask {
  readonly task: string;
  readonly count: number;
}

/** The other tasks that hand-ins belong to, the most frequent first. */
export function otherTasks({ handIns }: ClassResult): readonly OtherTask[] {
  const counts = new Map<string, number>();
  for (const { params } of handIns.flatMap(({ result }) =>
    result.remarks.filter(({ code }) => code === 'other-task'),
  )) {
    const task = String(params['task']);
    counts.set(task, (counts.get(task) ?? 0) + 1);
  }
  return [...counts].map(([task, count]) => ({ task, count })).toSorted((a, b) => b.count - a.count);
}

/** Maximum number of names listed, as a whole class may share one program. */
const MOST_NAMES = 10;

const twins = (names: readonly string[]): Remark => ({
  code: 'twins',
  params: { names: names.slice(0, MOST_NAMES).join(', ') + (names.length > MOST_NAMES ? ', …' : '') },
});

const withRemark = (result: CheckResult, remark: Remark): CheckResult => ({
  ...result,
  remarks: [...result.remarks, remark],
});
