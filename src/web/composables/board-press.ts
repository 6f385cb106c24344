import { isButtonKey, type BoardKey } from '../board/presses';
import type { RunModel } from './use-run';

/** Presses or lets go of a key of the board in the run. */
export function pressBoard(run: RunModel, key: BoardKey, down: boolean): void {
  if (isButtonKey(key)) run.input({ type: 'button', button: key, down });
  else run.input({ type: 'touch', pad: key, down });
}
