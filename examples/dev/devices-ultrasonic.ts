import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import { attachHcSr04 } from '#devices/hc-sr04';

import type { Print } from './example';

/** devices: an ultrasonic ranger on two wires, asked as a driver asks it: 10 µs on the trigger, then listen to the echo. */
export function main(print: Print): void {
  const clock = new Clock();
  const board = new Board(microbitV2, clock);
  attachHcSr04(clock, { trigger: board.wire('P1'), echo: board.wire('P2') }, () => 250);
  let roseUs = 0;
  board.wire('P2').onLevel((level) => {
    if (level === 1) roseUs = clock.nowUs;
    else print(`echo ${clock.nowUs - roseUs} µs long: ${Math.round(((clock.nowUs - roseUs) * 0.343) / 2)} mm`);
  });
  const trigger = board.pin('pin1');
  trigger.writeDigital(1);
  clock.advanceTo(10);
  trigger.writeDigital(0);
  clock.advanceTo(50_000);
}
