import type { Position } from './frames';
import type { Inspected } from './inspected';

/**
 * A place that a stepping debugger may stop at: a line of the pupil's files that begins, or one that resumes after a
 * call.
 */
export interface LineEvent extends Position {
  /** `line`: it begins, also once more when a loop comes back to it. `return`: a call in it has ended. */
  readonly kind: 'line' | 'return';
}

/** Decides whether a program stops at a line. */
export interface StopRule {
  (event: LineEvent): boolean;
  /** The only lines at whose beginning it may stop; it is not asked about others. Left out: it may stop anywhere. */
  readonly only?: readonly { readonly file: string; readonly line: number }[];
}

/** Finds the lines at which a debugger may stop. */
export interface LineFinder {
  readonly vm: Inspected;
  /** Reads where the program is now: the line in which it stands counts as begun. */
  start(): void;
  /** The line that begins or resumes with the next bytecode, or `null`: a line goes on. */
  next(): LineEvent | null;
}
