import type { Output } from '#simulation/causes/output';

/** A question for the line that caused something. */
export interface WhyAsked {
  /**
   * Its subject: an output, the robot and its actuators, everything there is, or a line in the console, given by the
   * number of the device's lines with the same time before it.
   */
  readonly about: Output | 'robot' | 'all' | { readonly printed: number };
  /** Place of its device. */
  readonly device: number;
  /** The moment in question. */
  readonly timeUs: number;
  /** Place on the page that was pointed at, in CSS px; left out: none. */
  readonly atPx?: { readonly x: number; readonly y: number };
  /** Distance to the left or right of `atPx` at which the answer is shown, in CSS px. */
  readonly besidePx?: number;
}
