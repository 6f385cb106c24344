import { csvText } from '#core/csv';
import type { Outcome } from './outcome';
import type { Value } from './what';

/** A run of a sweep: its values, in the order of what varies, and its result. */
export interface SweepRun extends Outcome {
  readonly values: readonly Value[];
}

/** The result of a sweep, its runs in their order. */
export interface SweepResult {
  /** Names of what varies. */
  readonly varied: readonly string[];
  readonly runs: readonly SweepRun[];
}

/** Number of runs that have passed. */
export const passedOf = ({ runs }: SweepResult): number => runs.filter(({ passed }) => passed === true).length;

const FIELDS = ['passed', 'atMs', 'touches', 'reason', 'xMm', 'yMm', 'headingDeg', 'pathMm', 'traceHash'] as const;

/** A sweep as one line of JSON, without wall times: equal work gives equal text. */
export function sweepJson(result: SweepResult): string {
  const runs = result.runs.map((run) => ({
    values: run.values,
    ...Object.fromEntries(FIELDS.map((field) => [field, run[field]])),
  }));
  return JSON.stringify({ varied: result.varied, runs, passed: passedOf(result), of: runs.length });
}

/** A sweep as a table for programs, a row for each run; RFC 4180. */
export const sweepCsv = ({ varied, runs }: SweepResult): string =>
  csvText([
    [...varied, ...FIELDS],
    ...runs.map((run) => [
      ...run.values,
      ...FIELDS.map((field) => {
        const cell = run[field];
        return typeof cell === 'boolean' ? Number(cell) : cell;
      }),
    ]),
  ]);
