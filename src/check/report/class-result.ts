import type { CheckResult, Remark } from '../result';

/** Result of one person's hand-in. */
export interface NamedResult {
  /** Unlike the others. */
  readonly name: string;
  readonly result: CheckResult;
  /** The teacher's note on it; left out: none. */
  readonly note?: string;
}

/** Results of a class. */
export interface ClassResult {
  /** Name of the task. */
  readonly task: string;
  /** In the order in which they were handed in. */
  readonly handIns: readonly NamedResult[];
}

/** Puts the results of a class together: those with the same program are marked. */
export function classResult(task: string, handIns: readonly NamedResult[]): ClassResult {
  const byTwin = new Map<string, string[]>();
  for (const { name, result } of handIns)
    if (result.twin !== '') byTwin.set(result.twin, [...(byTwin.get(result.twin) ?? []), name]);
  return {
    task,
    handIns: handIns.map((one) => {
      const { name, result } = one;
      const names = (byTwin.get(result.twin) ?? []).filter((other) => other !== name);
      return names.length === 0 ? one : { ...one, result: withRemark(result, twins(names)) };
    }),
  };
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
