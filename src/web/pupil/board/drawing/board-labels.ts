import type { BoardKey } from './presses';

/**
 * The labels of a board drawing for screen readers, in the user's language. The drawing itself writes only device
 * names.
 */
export interface BoardLabels extends Readonly<Record<BoardKey, string>> {
  /** The whole board, e.g. "micro:bit V2". */
  readonly board: string;
  /** The large buttons below the drawing. */
  readonly largeA: string;
  readonly largeB: string;
  /** Buttons A and B together. */
  readonly both: string;
  /** The 5 × 5 lights; their levels are added row by row. */
  readonly display: string;
  /** The light that shows that the microphone listens. */
  readonly microphone: string;
  /** The coloured lights of the board; their levels are added. */
  readonly rgb: string;
  /** The motor outputs; names and percentages are added. */
  readonly motors: string;
  /** The loudspeaker while it plays. */
  readonly speaker: string;
  /** Added while the board sleeps. */
  readonly asleep: string;
  /** Added once the board has switched itself off. */
  readonly off: string;
}
