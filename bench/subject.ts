/** One line of the table of budgets, before it is measured. */
export interface Budget {
  readonly what: string;
  readonly budget: string;
}

/** The measured value of one budget. */
export interface Figure {
  readonly text: string;
  /** True if it keeps the budget. */
  readonly met: boolean;
}

/** Budgets that are measured together, on something of type `Stage`. */
export interface Subject<Stage> {
  readonly budgets: readonly Budget[];
  /** One figure for each of the budgets, in their order. */
  measure(stage: Stage): Promise<readonly Figure[]>;
}

/** One finished line of the table. `met` is `null` where nothing could be measured. */
export interface Row extends Budget {
  readonly figure: string;
  readonly met: boolean | null;
}

/** The subjects of which a budget's name contains some words; all for none. */
export const named = <Stage>(subjects: readonly Subject<Stage>[], words: string): Subject<Stage>[] =>
  subjects.filter(({ budgets }) => budgets.some(({ what }) => what.includes(words)));

/** Measures subject after subject; a failing one says so in its lines and does not stop the others. */
export async function* measured<Stage>(subjects: readonly Subject<Stage>[], stage: Stage): AsyncGenerator<Row> {
  for (const subject of subjects) {
    const figures = await subject.measure(stage).catch((error: unknown) => firstLine(error));
    for (const [place, budget] of subject.budgets.entries()) {
      if (typeof figures === 'string') yield { ...budget, figure: `not measured: ${figures}`, met: null };
      else yield { ...budget, figure: figures[place]?.text ?? 'not measured', met: figures[place]?.met ?? null };
    }
  }
}

/** The lines of subjects that cannot be measured here. */
export function skipped(subjects: readonly Subject<never>[], reason: string): Row[] {
  return subjects
    .flatMap(({ budgets }) => budgets)
    .map((budget) => ({ ...budget, figure: `skipped: ${reason}`, met: null }));
}

/** The middle one of an odd number of values. */
export function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[(values.length - 1) >> 1] ?? NaN;
}

/** Does something several times, one after the other. */
export async function repeat<T>(rounds: number, work: () => Promise<T>): Promise<T[]> {
  const results: T[] = [];
  while (results.length < rounds) results.push(await work());
  return results;
}

const firstLine = (error: unknown): string =>
  (error instanceof Error ? error.message : String(error)).split('\n', 1)[0] ?? '';
