import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult, Reason } from '#check/result';
import type { Project } from '#project/project';

/** The initial data of a thread that checks. */
export interface CheckerData {
  /** The task, as its project says it. */
  readonly task: Project;
  readonly firmware: WebAssembly.Module;
  /** Shared words, see `BEAT` and `WORLD`. */
  readonly shared: Int32Array;
}

/** A hand-in that the thread shall check. */
export interface CheckRequest {
  readonly handIn: HandIn;
  /** From this world on nothing is run, for this reason. */
  readonly lost?: { readonly from: number; readonly reason: Reason };
}

/** Its answer. `broken`: an error of ours. */
export type CheckAnswer = { readonly result: CheckResult } | { readonly broken: string };

/** Index of the shared word that the thread counts up while time passes. */
export const BEAT = 0;

/** Index of the shared word that holds the place of the world that is being run. */
export const WORLD = 1;
