import { reasonOf } from './reason-of';
import type { Terminal } from './terminal';
import { writeOutput } from './write-output';

/** Says what is wrong. @returns the exit code for it */
export function refuse(problem: string, terminal: Terminal): 2 {
  for (const line of problem.split('\n')) terminal.message(`parcours: ${line}`);
  return 2;
}

/** A file to write: its option, its path or `null`, its text. */
type Written = readonly [option: string, path: string | null, textOf: () => string];

/** Writes all that can be written. @returns the problems with the others */
export const writeReports = (files: readonly Written[]): readonly string[] =>
  files.flatMap(([option, path, textOf]) => {
    try {
      if (path !== null) writeOutput(path, textOf());
      return [];
    } catch (error) {
      return [`${option}: ${path ?? ''}: ${reasonOf(error)}`];
    }
  });

/** Shows the progress: on a terminal in one line that is replaced, elsewhere now and then. */
export class CountProgress {
  private done = 0;
  private toldMs = performance.now();

  constructor(
    private readonly terminal: Terminal,
    private readonly of: number,
    private readonly isQuiet: boolean,
    private readonly textOf: (done: number) => string,
  ) {}

  add(count: number): void {
    this.done += count;
    if (this.isQuiet || count === 0) return;
    const text = this.textOf(this.done);
    this.terminal.count(this.done / this.of, text);
    const nowMs = performance.now();
    if (this.terminal.showsProgress || nowMs - this.toldMs < TELL_MS) return;
    this.toldMs = nowMs;
    this.terminal.message(text);
  }
}

/** Chosen: a log of ten thousand runs stays readable. */
const TELL_MS = 10_000;
