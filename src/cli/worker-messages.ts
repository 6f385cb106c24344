import type { RunEnd } from '#lab/run-end';
import type { RunSetup } from '#simulation/run-setup';
import type { Moment } from '#tape/moment';
import type { TapeResult } from '#tape/result';
import type { StopAsked } from './replay/replay-arguments';
import type { RadioNews } from './radio-report';
import type { Report } from './report';
import type { SharedConsole } from './shared-console';

/** The worker's initial data. */
export interface WorkerTask extends RunEnd {
  readonly setup: RunSetup;
  /** An open file for the trace, or `null`. */
  readonly traceFile: number | null;
  /** An open file for the data log, or `null`. */
  readonly logFile: number | null;
  /** An open file for the recording, or `null`. */
  readonly tapeFile: number | null;
  /** The run is a repetition: it reports its result and, if it stops early, the moment. */
  readonly replay: ReplayTask | null;
  /** Shared words, see `BEAT` and `INTERRUPT`. */
  readonly shared: Int32Array;
  /** Receives the program's output. */
  readonly console: SharedConsole;
}

/** The order for repeating a recorded run. */
export interface ReplayTask {
  /** Point at which it stops; `null`: at its end. */
  readonly stop: StopAsked | null;
  /** Place of the device that is looked at. */
  readonly device: number;
}

/** Result of a repetition. */
export interface ReplayOutcome {
  readonly result: TapeResult;
  /** Moment at which it stopped; `null`: no stop was requested, or the line was not reached. */
  readonly moment: Moment | null;
}

/** Index of the shared word that the worker counts up while time passes. */
export const BEAT = 0;

/** Index of the shared word that is 1 when the program must be interrupted. */
export const INTERRUPT = 1;

/** From the worker, in this order: any number of `progress`, then one of the others. */
export type WorkerMessage =
  | { readonly type: 'progress'; readonly report: Report; readonly radio: readonly RadioNews[] }
  | {
      readonly type: 'done';
      readonly report: Report;
      readonly radio: readonly RadioNews[];
      readonly replay: ReplayOutcome | null;
    }
  /** The set-up cannot run: the user's mistake. */
  | { readonly type: 'refused'; readonly problem: string }
  /** An internal error: our mistake. */
  | { readonly type: 'broken'; readonly problem: string };
