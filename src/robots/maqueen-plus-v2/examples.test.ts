import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV2Build } from './robot';
import { maqueenPlusV2Sheet } from './sheet';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Lets one of the robot's example programs run. */
function runExample(file: string, forMs: number, setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV2Build, setup);
  const source = maqueenPlusV2Sheet.examples.find((example) => example.file === file)?.source.en ?? '';
  const { exception, hasEnded } = floor.run(firmware, source, forMs);
  expect(exception).toBeNull();
  return { ...floor, hasEnded };
}

/** A closed black line, a circle of this radius that leads forward under the middle sensor, to the left. */
function circle(radiusMm: number): FloorSetup {
  const centre: Vec = { x: 1056, y: 1000 + radiusMm };
  const pointsMm = Array.from({ length: 91 }, (_, i) => {
    const angle = (i / 90) * 2 * Math.PI;
    return { x: centre.x + radiusMm * Math.sin(angle), y: centre.y - radiusMm * Math.cos(angle) };
  });
  return { prepare: (world) => world.addStroke({ pointsMm, widthMm: 20, reflectance: 0 }) };
}

describe('Maqueen Plus V2, its examples', () => {
  it.each([200, 400])('line.py follows a circle of %i mm radius all the way round', (radiusMm) => {
    const { chassis } = runExample('line.py', 60_000, circle(radiusMm));
    expect(chassis.turnedRad()).toBeGreaterThan(2 * Math.PI);
    const { xMm, yMm } = chassis.pose();
    expect(Math.abs(Math.hypot(xMm - 1056, yMm - 1000 - radiusMm) - radiusMm)).toBeLessThan(60);
  });

  it('distance.py drives half a minute about the arena and touches nothing', () => {
    const { chassis } = runExample('distance.py', 30_000);
    expect(chassis.pathMm()).toBeGreaterThan(2000);
    expect(chassis.collisions()).toBe(0);
  });

  it('servo.py closes and opens the claw at P1', () => {
    const { robot, hasEnded } = runExample('servo.py', 10_000, { options: { P1: 'claw' } });
    expect(hasEnded).toBe(true);
    expect(Math.abs(robot.state().attachments[0]!.angleDeg - 35)).toBeLessThan(5);
  });

  it.each(['first_drive.py', 'lights.py'])('%s ends with motors and lights off', (file) => {
    const { robot, hasEnded } = runExample(file, 20_000);
    expect(hasEnded).toBe(true);
    const { duty, leds } = robot.state();
    expect([duty, leds]).toEqual([
      { left: 0, right: 0 },
      { left: 0, right: 0 },
    ]);
  });
});
