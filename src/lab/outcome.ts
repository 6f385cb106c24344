import type { Vec } from '#core/geometry';
import type { Point } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

/** Why a run has not passed, as a word: the judge's, or its own. */
export type OutcomeReason =
  | NonNullable<Verdict['reason']>
  /** `open`: not done when the run was over. */
  | 'open'
  | 'helped'
  /** The program ended with an error. */
  | 'exception'
  | 'panic'
  /** Inside one call that never ends. */
  | 'stuck';

/** The result of one run, as plain data. */
export interface Outcome {
  /** `null`: the course has no task. */
  readonly passed: boolean | null;
  /** Simulated time of the task's decision; without a task that of the program's end. `null`: neither came. */
  readonly atMs: number | null;
  readonly touches: number;
  readonly reason: OutcomeReason | null;
  /** The first robot at the end of the run; `null`: there is none. */
  readonly xMm: number | null;
  readonly yMm: number | null;
  readonly headingDeg: number | null;
  readonly pathMm: number | null;
  /** The run's fingerprint. */
  readonly traceHash: string;
}

/** The result of a run. */
export interface RunResult {
  readonly outcome: Outcome;
  readonly verdict: Verdict | null;
  /** Its way, if that was asked for. */
  readonly drive?: Drive;
}

/** The way of the first robot, thinned, and the simulated time at the end of the run. */
export interface Drive {
  readonly way: readonly (readonly Point[])[];
  readonly endUs: number;
  /** Places of its line sensors, robot frame, on the real robot; in mm. */
  readonly lineMm: readonly Vec[];
}

/** The result of a run that was stuck inside one call: nothing of it is known. */
export const stuckOutcome = (hasTask: boolean): Outcome => ({
  passed: hasTask ? false : null,
  ...{ atMs: null, touches: 0, reason: 'stuck' },
  ...{ xMm: null, yMm: null, headingDeg: null, pathMm: null, traceHash: '' },
});
