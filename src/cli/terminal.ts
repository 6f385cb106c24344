import { unseenShown } from '#core/unseen';

/** The destination of a run's text: the program's output goes to stdout, our messages to stderr. */
export interface Terminal {
  /** Output of the program; prints nothing when quiet. */
  program(text: string): void;
  /** A line of ours for other programs, on stdout, on a line of its own. */
  line(text: string): void;
  /** A message of ours. */
  message(text: string): void;
  /** Shows the progress of the run, in one line that is replaced; only on a terminal. */
  progress(simulatedMs: number, realTimeFactor: number): void;
  /** Shows which share of several things is done, in such a line with a bar and a text. */
  count(share: number, text: string): void;
  /** True if progress is shown: on a terminal, unless quiet. */
  readonly showsProgress: boolean;
  /** Removes the progress line. */
  clearProgress(): void;
}

/** The terminal's output stream; `isTTY` if it is a terminal. */
export interface Stream {
  write(text: string): unknown;
  readonly isTTY?: boolean | undefined;
}

/** Length of the bar. */
const BAR_SIGNS = 30;

const CLEAR_LINE = '\r\u001b[K';

/** Names and values may contain invisible or terminal control characters: they are shown, not sent. */
export const printable = (text: string): string =>
  unseenShown(text).replace(
    /[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/g,
    (sign) => `\\x${sign.charCodeAt(0).toString(16).padStart(2, '0')}`,
  );

/** Creates the terminal of one run. */
export function createTerminal(out: Stream, err: Stream, quiet: boolean): Terminal {
  const showsProgress = err.isTTY === true && !quiet;
  let shown = false;
  let atLineStart = true;
  const clearProgress = (): void => {
    if (shown) err.write(CLEAR_LINE);
    shown = false;
  };
  // Half a line of the program's output would be overwritten: progress waits for the end of the line.
  const replace = (text: string): void => {
    if (!showsProgress || (out.isTTY === true && !atLineStart)) return;
    shown = true;
    err.write(CLEAR_LINE + text);
  };
  return {
    clearProgress,
    showsProgress,
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
      err.write(`${printable(text)}\n`);
    },
    progress: (simulatedMs, realTimeFactor) =>
      replace(`${(simulatedMs / 1000).toFixed(1)} s simulated, ${Math.round(realTimeFactor)} × real time`),
    count(share, text) {
      const full = Math.round(BAR_SIGNS * share);
      replace(`${'█'.repeat(full)}${'░'.repeat(BAR_SIGNS - full)} ${text}`);
    },
  };
}
