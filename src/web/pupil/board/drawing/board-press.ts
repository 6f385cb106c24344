import { isButtonKey, type BoardKey } from './presses';
import type { RunModel } from '../../../session/run/run-model';

/** Presses or releases a key of a device's board in the run, by default of the device that is shown. */
export function pressBoard(run: RunModel, key: BoardKey, down: boolean, device = run.device): void {
  if (isButtonKey(key)) run.input({ type: 'button', button: key, down }, device);
  else run.input({ type: 'touch', pad: key, down }, device);
}
