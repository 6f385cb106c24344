/** The problems of the transfer to the device. Plain data; the words are in `words`. */
export type PutProblem =
  /** Nothing at all comes back. */
  | { readonly kind: 'silent' }
  /**
   * Something comes back, but never MicroPython's prompt: the firmware is another one, or the program ignores Ctrl-C.
   */
  | { readonly kind: 'no-prompt' }
  /** Another program or another tab has the line. */
  | { readonly kind: 'line-in-use' }
  /** The page is in a frame that may not use serial lines. */
  | { readonly kind: 'frame' }
  /** The program needs a module that this device does not have. */
  | { readonly kind: 'wrong-board'; readonly module: string; readonly machine: string }
  /** About `overBytes` did not fit; `others` are the files on the device that do not belong to this project. */
  | { readonly kind: 'full'; readonly file: string; readonly overBytes: number; readonly others: readonly string[] }
  /** The cable came out, or the device was switched off. */
  | { readonly kind: 'interrupted' }
  /** The device stopped answering halfway through. */
  | { readonly kind: 'stuck' }
  /** The device's answers make no sense. */
  | { readonly kind: 'garbled' }
  /** The file read back differed from the file sent, twice. */
  | { readonly kind: 'different'; readonly file: string }
  /** Python on the device raised an exception; in its own words. */
  | { readonly kind: 'exception'; readonly text: string }
  /** Stopped by the pupil. `isTouched`: something on the device had been changed by then. */
  | { readonly kind: 'stopped'; readonly isTouched: boolean };

/** Ends the exchange with the device. It is caught in this room and never reaches the page. */
export class PutError extends Error {
  constructor(readonly problem: PutProblem) {
    super(problem.kind);
  }
}
