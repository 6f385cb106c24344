import type { Outcome } from '#lab/outcome';
import type { RunEnd } from '#lab/run-end';
import type { RunSetup } from '#simulation/run-setup';
import type { Verdict } from '#simulation/task/verdict';
import type { SharedWords } from '../threads/threads';

/** The initial data of a thread that makes runs. */
export interface RunnerData extends SharedWords {
  readonly firmware: WebAssembly.Module;
}

/** A run that a thread shall make. */
export interface RunRequest {
  readonly setup: RunSetup;
  readonly end: RunEnd;
}

/** Its result. `refused`: it cannot run, for this reason in words. */
export type RunAnswer = { readonly outcome: Outcome; readonly verdict: Verdict | null } | { readonly refused: string };
