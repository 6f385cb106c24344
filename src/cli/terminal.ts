/** Where the run's words go: the program's to stdout, ours to stderr. */
export interface Terminal {
  /** What the program printed; says nothing when quiet. */
  program(text: string): void;
  /** A line of ours for other programs, on stdout, on a line of its own. */
  line(text: string): void;
  /** A message of ours. */
  message(text: string): void;
  /** Shows how far the run is, in one line that is replaced; only where a person looks on. */
  progress(simulatedMs: number, realTimeFactor: number): void;
  /** Takes the progress away. */
  clearProgress(): void;
}

/** What the terminal writes to; `isTTY` where a person looks on. */
export interface Stream {
  write(text: string): unknown;
  readonly isTTY?: boolean | undefined;
}

const CLEAR_LINE = '\r\u001b[K';

/** Creates the terminal of one run. */
export function createTerminal(out: Stream, err: Stream, quiet: boolean): Terminal {
  const showsProgress = err.isTTY === true && !quiet;
  let shown = false;
  let atLineStart = true;
  const clearProgress = (): void => {
    if (shown) err.write(CLEAR_LINE);
    shown = false;
  };
  return {
    clearProgress,
    program(text) {
      if (quiet || text === '') return;
      clearProgress();
      out.write(text);
      atLineStart = text.endsWith('\n');
    },
    line(text) {
      clearProgress();
      out.write(`${atLineStart ? '' : '\n'}${text}\n`);
      atLineStart = true;
    },
    message(text) {
      clearProgress();
      err.write(`${text}\n`);
    },
    progress(simulatedMs, realTimeFactor) {
      // Half a line of the program's output would be overwritten: progress waits for the line's end.
      if (!showsProgress || (out.isTTY === true && !atLineStart)) return;
      shown = true;
      err.write(
        `${CLEAR_LINE}${(simulatedMs / 1000).toFixed(1)} s simulated, ${Math.round(realTimeFactor)} × real time`,
      );
    },
  };
}
