import type { RunSetup } from '#simulation/run-setup';
import type { TapeResult } from './result';

/** A run that can be run again: what it depends on, and what it came to. */
export interface Tape {
  /** Version of the Parcours that has recorded it. */
  readonly madeBy: string;
  /** With every input of the run, at its time. */
  readonly setup: RunSetup;
  /** The run goes on until this simulated time, or, if it says so, until all programs have ended. */
  readonly untilUs: number;
  readonly untilProgramEnds: boolean;
  readonly result: TapeResult;
}
