import { STEP_US } from '#world/step';
import { createWorld } from '#world/world';

import type { Print } from './example';

/** world: an arena without a robot. A line is drawn and a wall put up; a mover comes up from below, and two probes ask. */
export function main(print: Print): void {
  const world = createWorld({ widthMm: 1000, heightMm: 500 });
  world.addWall({ id: 'wall', fromMm: { x: 800, y: 100 }, toMm: { x: 800, y: 400 }, thicknessMm: 10 });
  world.addStroke({
    pointsMm: [
      { x: 100, y: 250 },
      { x: 700, y: 250 },
    ],
    widthMm: 20,
    reflectance: 0.05,
  });
  const cone = { rangeMm: 4500, openingRad: 0.26 };
  const ahead = (): number => Math.round(world.distanceCone({ x: 100, y: 250 }, 0, cone).distanceMm);
  print(
    `on the line ${world.reflectanceAt({ x: 400, y: 250 }, 2)}, beside it ${world.reflectanceAt({ x: 400, y: 300 }, 2)}`,
  );
  world.addMover({
    sizeMm: { x: 60, y: 60 },
    angleRad: 0,
    speedMmPerS: 200,
    spinRadPerS: 0,
    goes: {
      stops: [
        { atMm: { x: 400, y: 50 }, waitS: 0 },
        { atMm: { x: 400, y: 450 }, waitS: 0 },
      ],
      loops: false,
      phaseS: 0,
    },
  });
  print(`the wall is ${ahead()} mm ahead`);
  for (let timeUs = 0; timeUs < 1_000_000; timeUs += STEP_US) world.step();
  print(`after a second something is ${ahead()} mm ahead`);
}
