import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { OptionValues } from '#core/option';
import { putOnFloor } from '../testing/floor';
import { maqueenLiteBuild } from './robot';
import { maqueenLiteSheet } from './sheet';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Lets one of the robot's example programs run to its end. */
function runExample(file: string, options: OptionValues = {}) {
  const floor = putOnFloor(maqueenLiteBuild, { options });
  const source = maqueenLiteSheet.examples.find((example) => example.file === file)?.source.en ?? '';
  const { exception, hasEnded } = floor.run(firmware, source, 30_000);
  expect([exception, hasEnded]).toEqual([null, true]);
  return floor;
}

describe('Maqueen Lite, its examples', () => {
  it('square.py turns by 360 degrees, within 10, and comes back to within 10 cm of its start', () => {
    const { chassis } = runExample('square.py');
    expect(Math.abs((chassis.turnedRad() * 180) / Math.PI - 360)).toBeLessThan(10);
    expect(Math.hypot(chassis.pose().xMm - 1000, chassis.pose().yMm - 1000)).toBeLessThan(100);
  });

  it('servo.py closes and opens the claw at S1', () => {
    const { robot } = runExample('servo.py', { S1: 'claw' });
    expect(robot.state().attachments[0]?.angleDeg).toBe(35);
  });

  it.each(['first_drive.py', 'lights.py'])('%s ends with motors and lights off', (file) => {
    const { duty, leds, rgb } = runExample(file).robot.state();
    expect([duty, leds]).toEqual([
      { left: 0, right: 0 },
      { left: 0, right: 0 },
    ]);
    expect(rgb.flat().every((part) => part === 0)).toBe(true);
  });
});
