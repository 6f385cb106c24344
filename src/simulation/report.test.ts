import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { robotReport } from './report';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** The command line's report of a robot after a second. */
async function reportOf(robot: string, program: string) {
  const setup = { scene: defaultScene(), files: { 'main.py': program }, robot, board: 'auto', seed: 1, reality: 0 };
  const run = await Simulation.create(soloRun(setup), firmware);
  run.advanceTo(1_000_000);
  expect(run.ended?.exception ?? null).toBeNull();
  return robotReport(run.snapshot().robot!);
}

describe('the report of a robot', { timeout: 30_000 }, () => {
  it('gives colour lamps by their numbers, lights by red, green and blue, servos in degrees: Maqueen Plus V3', async () => {
    const program = 'from mbrobot_plusV3 import *\nsetLEDs(1, 6)\nposRGB(2, 7, 8, 9)\nsetServo("S1", 90)\n';
    const { leds, lamps, rgb, servos } = await reportOf('maqueen-plus-v3', program);
    expect([leds, lamps, servos]).toEqual([{ left: 0, right: 0 }, [1, 6], { P0: 90 }]);
    expect(rgb).toEqual([[0, 0, 0], [0, 0, 0], [7, 8, 9], [0, 0, 0]]); // prettier-ignore
  });

  it('gives no lamps for a robot with red lights', async () => {
    const { leds, lamps } = await reportOf('maqueen-plus-v2', 'from mbrobot_plusV2 import *\nsetLED(1, 0)\n');
    expect([leds, lamps]).toEqual([{ left: 1, right: 0 }, []]);
  });
});
