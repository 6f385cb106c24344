import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';

import type { Print } from './example';

/** board: a micro:bit without a VM. A chip listens to pin 0 while the pin puts out a servo signal. */
export function main(print: Print): void {
  const clock = new Clock();
  const board = new Board(microbitV2, clock);
  board.wire('P0').onPwm((pwm) => print(pwm === null ? 'no signal' : `period ${pwm.periodUs} µs`));
  const pin = board.pin('pin0');
  pin.setAnalogPeriodUs(20_000);
  pin.writeAnalog(77);
  clock.advanceTo(100_000);
  pin.writeDigital(0);
}
