import { isButtonKey, type BoardKey } from './presses';
import type { Speed } from '../../run/worker/protocol';
import type { RunModel } from '../../run/run-model';

/** Presses or lets go of a key of the board in the run. */
export function pressBoard(run: RunModel, key: BoardKey, down: boolean): void {
  if (isButtonKey(key)) run.input({ type: 'button', button: key, down });
  else run.input({ type: 'touch', pad: key, down });
}

/** How many times slower than real time runs go that are set to this speed; a tap has to last as much longer. */
export const slownessOf = (speed: Speed): number => (speed === 'max' ? 1 : Math.max(1, 1 / speed));
