import { fitRun } from '#simulation/run-problem';
import type { RunSetup } from '#simulation/run-setup';
import type { Verdict } from '#simulation/task/verdict';
import { ranTo, type Outcome, type Runner } from './outcome';
import type { RunEnd } from './run-end';

/** A run that a thread shall make. */
export interface RunRequest {
  readonly setup: RunSetup;
  readonly end: RunEnd;
}

/** Its result. `refused`: it cannot run, for this reason in words. */
export type RunAnswer = { readonly outcome: Outcome; readonly verdict: Verdict | null } | { readonly refused: string };

/** Makes a run. */
export function answerRun({ setup, end }: RunRequest, runner: Runner): Promise<RunAnswer> {
  const checked = fitRun(setup);
  return 'problem' in checked ? Promise.resolve({ refused: checked.problem }) : ranTo(setup, end, runner);
}
