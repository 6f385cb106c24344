import { isButtonKey, type BoardKey } from './presses';
import type { RunModel } from '../../run/run-model';

/** Presses or lets go of a key of the board in the run. */
export function pressBoard(run: RunModel, key: BoardKey, down: boolean): void {
  if (isButtonKey(key)) run.input({ type: 'button', button: key, down });
  else run.input({ type: 'touch', pad: key, down });
}
