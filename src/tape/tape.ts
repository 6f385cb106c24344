import type { RunSetup } from '#simulation/run-setup';
import type { TapeResult } from './result';

/** The name of the format in the file. */
export const TAPE_FORMAT = 'parcours-tape';

/** True if a file says that it is a recorded run, also one that was cut off: no text within JSON has such quotes. */
export const isTapeFile = (text: string): boolean => /"format":\s*"parcours-tape"/.test(text);

/** A run that can be run again: what it depends on, and what it came to. */
export interface Tape {
  /** Version of the Parcours that has recorded it. */
  readonly madeBy: string;
  /** The physics with which it was recorded: see `PHYSICS`. */
  readonly physics: number;
  /** With every input of the run, at its time. */
  readonly setup: RunSetup;
  /** The run goes on until this simulated time, or, if it says so, until all programs have ended. */
  readonly untilUs: number;
  readonly untilProgramEnds: boolean;
  readonly result: TapeResult;
}
