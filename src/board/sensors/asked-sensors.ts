import type { BoardType } from '../boards/board-type';
import { limitReach, WIDEST_G } from './motion';
import { padId, Sensors } from './sensors';

/** A button or pad that nothing hangs on. */
const UNWIRED = { press: () => undefined, release: () => undefined, isDown: false };

/**
 * The sensors of a kind of board without the board, to ask what can be set (`problemOf`). The accelerometer reaches as
 * far as a program can make it: what a run's program has chosen is known only there.
 */
export function askedSensors({ pins }: BoardType): Sensors {
  const pads = pins.filter(({ touch }) => touch !== null).map(({ name }) => padId(name));
  const sensors = new Sensors(new Map(['buttonA', 'buttonB', ...pads].map((id) => [id, UNWIRED])));
  limitReach(sensors, WIDEST_G * 1000);
  return sensors;
}
