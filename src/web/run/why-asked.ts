import type { Output } from '#simulation/causes/output';

/** Somebody wants to know which line has made something so. */
export interface WhyAsked {
  /**
   * What it is about: an output, the robot and what drives it, all that there is, or a line in the console, by how many
   * lines of the device with the same time come before it.
   */
  readonly about: Output | 'robot' | 'all' | { readonly printed: number };
  /** Place of its device. */
  readonly device: number;
  /** The moment that is meant. */
  readonly timeUs: number;
  /** Where on the page somebody has pointed, in CSS px; left out: nowhere. */
  readonly atPx?: { readonly x: number; readonly y: number };
  /** How far to the sides of it the answer stays away, in CSS px. */
  readonly besidePx?: number;
}
