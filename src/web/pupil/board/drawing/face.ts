import type { Rgb } from '#core/rgb';
import type { BoardLabels } from './board-labels';
import type { BoardKey } from './presses';
import type { PressHandlers } from './use-presses';

/** Whether the board is awake, sleeps until something wakes it, or has switched itself off. */
export type Power = 'on' | 'asleep' | 'off';

/** The state that the drawing of one board shows, and its presses. */
export interface FaceProps {
  /** 25 levels 0 … 9, row by row. */
  readonly display: readonly number[];
  readonly rgb: readonly Rgb[];
  /** Duty of each motor output, −1 … 1, positive forwards. */
  readonly motors: readonly number[];
  readonly microphoneOn: boolean;
  readonly sounding: boolean;
  readonly power: Power;
  /** True if its lights can glow: it has power and is awake. */
  readonly lit: boolean;
  /** True if simulated time passes; when not, nothing in the drawing moves. */
  readonly moving: boolean;
  /** The keys that look pressed. */
  readonly down: ReadonlySet<BoardKey>;
  readonly handlers: Readonly<Record<BoardKey, PressHandlers>>;
  readonly labels: BoardLabels;
}
