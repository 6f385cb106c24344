/** What can go wrong during the transfer to the device. Plain data; the words are in `words`. */
export type PutProblem =
  /** Nothing at all comes back. */
  | { readonly kind: 'silent' }
  /** Something comes back, yet never MicroPython's prompt: another firmware, or a program that does not let go. */
  | { readonly kind: 'no-prompt' }
  /** Another program or another tab has the line. */
  | { readonly kind: 'line-in-use' }
  /** The page is in a frame that may not use serial lines. */
  | { readonly kind: 'frame' }
  /** The program wants a module that this device does not have. */
  | { readonly kind: 'wrong-board'; readonly module: string; readonly machine: string }
  /** `overBytes` did not fit, about; `others` are the files on the device that are not of this project. */
  | { readonly kind: 'full'; readonly file: string; readonly overBytes: number; readonly others: readonly string[] }
  /** The cable came out, or the device was switched off. */
  | { readonly kind: 'interrupted' }
  /** The device no longer answers in the middle. */
  | { readonly kind: 'stuck' }
  /** The device answers what makes no sense. */
  | { readonly kind: 'garbled' }
  /** What was read back is not what was sent, twice. */
  | { readonly kind: 'different'; readonly file: string }
  /** Python on the device says no; its own words. */
  | { readonly kind: 'exception'; readonly text: string }
  /** The pupil wanted it. `isTouched`: something on the device had been changed by then. */
  | { readonly kind: 'stopped'; readonly isTouched: boolean };

/** Leaves the dialogue with the device. Caught in this room: it never reaches the page. */
export class PutError extends Error {
  constructor(readonly problem: PutProblem) {
    super(problem.kind);
  }
}
