import { fitRun } from '#simulation/run-problem';
import type { RunSetup } from '#simulation/run-setup';
import type { RunResult } from './outcome';
import { ranTo, type Runner } from './ran-to';
import type { RunEnd } from './run-end';

/** A run that a thread shall make. */
export interface RunRequest {
  readonly setup: RunSetup;
  readonly end: RunEnd;
  /** True: its way is wanted, too. */
  readonly withDrive?: boolean;
}

/** Its result. `refused`: it cannot run, for this reason in words. */
export type RunAnswer = RunResult | { readonly refused: string };

/** Makes a run. */
export function answerRun({ setup, end, withDrive }: RunRequest, runner: Runner): Promise<RunAnswer> {
  const checked = fitRun(setup, true);
  return 'problem' in checked ? Promise.resolve({ refused: checked.problem }) : ranTo(setup, end, runner, withDrive);
}
