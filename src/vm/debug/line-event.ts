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

/** True if a program shall stop there. */
export interface StopRule {
  (event: LineEvent): boolean;
  /** It stops at the beginnings of these lines at most, and need not hear of others; left out: anywhere. */
  readonly only?: readonly { readonly file: string; readonly line: number }[];
}

/** Finds the lines that begin. */
export interface LineFinder {
  readonly vm: Inspected;
  /** Looks where the program is now: the line in which it stands does not begin any more. */
  start(): void;
  /** The line that begins with the next bytecode, or `null`: a line goes on. */
  next(): LineEvent | null;
}
