import type { BoardKey } from '../board/presses';
import type { RunModel } from './use-run';

/** Presses or lets go of a key of the board in the run. */
export function pressBoard(run: RunModel, key: BoardKey, down: boolean): void {
  if (key === 'logo') run.input({ type: 'touch', pad: 'pinLogo', down });
  else run.input({ type: 'button', button: key, down });
}
