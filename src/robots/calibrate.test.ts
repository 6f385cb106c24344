import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { maqueenLiteBuild } from './maqueen-lite/robot';
import { maqueenPlusV2Build } from './maqueen-plus-v2/robot';
import type { RobotBuild } from './robot';
import { putOnFloor } from './testing/floor';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

interface Robot {
  readonly build: RobotBuild;
  readonly module: string;
}

const STRONG_LEFT = [1.05, 0.95] as const;
const STRONG_RIGHT = [0.95, 1.05] as const;

/** Distance of a robot to the left of a straight path after 3.5 s, in mm. */
function leftOfStraightMm({ build, module }: Robot, strength: readonly [number, number], calibration: string): number {
  const { chassis, run } = putOnFloor(build, { strength });
  const program = `from ${module} import *\n${calibration}\nforward()\ndelay(3500)\nstop()\n`;
  expect(run(firmware, program, 3500).exception).toBeNull();
  expect(chassis.pathMm()).toBeGreaterThan(400);
  return chassis.pose().yMm - 1000;
}

describe.each([
  { module: 'mbrobot', build: maqueenLiteBuild, differential: 6 },
  { module: 'mbrobot_plusV2', build: maqueenPlusV2Build, differential: 10 },
])('calibrate() of $module, for motors of which one is 10 % stronger than the other', ({ differential, ...robot }) => {
  it('has something to mend: the robot leaves its way by more than 4 cm in half a metre', () => {
    expect(leftOfStraightMm(robot, STRONG_LEFT, '')).toBeLessThan(-40);
    expect(leftOfStraightMm(robot, STRONG_RIGHT, '')).toBeGreaterThan(40);
  });

  it(`straightens it to 1.5 cm with a differential of ${differential}, and of −${differential} for the other side`, () => {
    expect(Math.abs(leftOfStraightMm(robot, STRONG_LEFT, `calibrate(0, ${differential})`))).toBeLessThan(15);
    expect(Math.abs(leftOfStraightMm(robot, STRONG_RIGHT, `calibrate(0, ${-differential})`))).toBeLessThan(15);
  });
});
