import { findAttachment } from '#attachments/types';
import { maqueenLite } from '#robots/maqueen-lite/type';
import { STEP_US } from '#world/step';
import { createWorld } from '#world/world';

import type { Print } from './example';

/** attachments: a claw on a robot without a board. It closes around a block, and the block comes along. */
export function main(print: Print): void {
  const world = createWorld({ widthMm: 1200, heightMm: 900 });
  const chassis = world.addChassis(maqueenLite.body, { xMm: 400, yMm: 450, headingRad: 0 });
  const front = Math.max(...maqueenLite.body.outlineMm.flat().map(({ x }) => x));
  const claw = findAttachment('claw')?.attach({ chassis, mountMm: { x: front, y: 0 }, scale: 1 });
  const block = world.addBlock({
    atMm: { x: 400 + front + 30, y: 450 },
    sizeMm: { x: 40, y: 40 },
    angleRad: 0,
    fixed: false,
  });
  for (let angleDeg = 30; angleDeg <= 100; angleDeg += 1) {
    claw?.move(angleDeg);
    world.step();
  }
  print(claw?.isHolding() === true ? 'held' : 'not held');
  chassis.setDuty(0, -1);
  chassis.setDuty(1, -1);
  for (let timeUs = 0; timeUs < 500_000; timeUs += STEP_US) world.step();
  print(block.pose().xMm < 400 + front + 30 ? 'the block comes along' : 'the block stays');
}
