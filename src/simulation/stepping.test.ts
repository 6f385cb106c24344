import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { readPosition } from '#vm/debug/frames';
import { afterStep, atBreakPoints, type Step } from '#vm/debug/stops';
import { readVariables } from '#vm/debug/variables';
import { soloRun, type RunSetup } from './run-setup';
import { Simulation } from './simulation';
import { convoyOf } from './testing/convoy';
import { defaultScene } from '#scene/scene';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const ENOUGH_US = 3_000_000;

/** The outcome of a run. */
const outcomeOf = (simulation: Simulation, devices: number) => ({
  nowUs: simulation.nowUs,
  hash: simulation.traceHash,
  consoles: Array.from({ length: devices }, (_, place) => simulation.takeConsole(place)),
  free: Array.from({ length: devices }, (_, place) => simulation.heapFree(place)),
  snapshot: simulation.snapshot(),
});

async function undisturbed(setup: RunSetup) {
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(ENOUGH_US);
  return outcomeOf(simulation, setup.devices.length);
}

/** The same run by steps of one device, with a look at its variables at each stop. */
async function stepped(setup: RunSetup, device: number, steps: readonly Step[]) {
  const simulation = await Simulation.create(setup, firmware);
  let stops = 0;
  while (simulation.nowUs < ENOUGH_US) {
    const from = readPosition(simulation.inspect(device)!);
    const step = steps[stops % steps.length]!;
    // Out of the program itself nothing leads but its end.
    simulation.watch(afterStep(step === 'out' && from?.depth === 0 ? 'over' : step, from), device);
    simulation.advanceTo(ENOUGH_US);
    if (simulation.heldBy === null) break;
    expect(simulation.heldBy).toBe(device);
    expect(readVariables(simulation.inspect(device)!).stack.length).toBeGreaterThan(0);
    stops++;
  }
  return { outcome: outcomeOf(simulation, setup.devices.length), stops };
}

const drive = soloRun({
  scene: defaultScene(),
  files: {
    'main.py':
      'from mbrobot import *\ndef turn(n):\n    for i in range(n):\n        left()\n        delay(20)\nwhile True:\n    forward()\n    delay(30)\n    turn(3)\n    print(getDistance())',
  },
  robot: 'maqueen-lite',
  board: 'microbit-v2',
  seed: 3,
  reality: 0.5,
});

describe('a run that is stepped', { timeout: 120_000 }, () => {
  it('is the run that nobody has stopped, with a robot', async () => {
    const { outcome, stops } = await stepped(drive, 0, ['over', 'into', 'into', 'out']);
    expect(stops).toBeGreaterThan(50);
    expect(outcome).toEqual(await undisturbed(drive));
  });

  it('stands still with its motors: time does not pass at a break point', async () => {
    const simulation = await Simulation.create(drive, firmware);
    simulation.watch(atBreakPoints([{ file: 'main.py', line: 9 }]));
    simulation.advanceTo(ENOUGH_US);
    expect(simulation.heldBy).toBe(0);
    const { nowUs } = simulation;
    expect(nowUs).toBeLessThan(100_000);
    expect(readPosition(simulation.inspect()!)).toEqual({ file: 'main.py', line: 9, depth: 0 });
    expect(simulation.snapshot().robot?.state.duty.left).toBeGreaterThan(0);
    simulation.watch(null);
    simulation.advanceTo(ENOUGH_US);
    expect([simulation.heldBy, simulation.nowUs >= ENOUGH_US]).toEqual([null, true]);
  });

  it.each([0, 1, 3])('is the run that nobody has stopped, with four devices, device %i stepped', async (device) => {
    const setup = convoyOf(4);
    const { outcome, stops } = await stepped(setup, device, ['into', 'over', 'over', 'out']);
    expect(stops).toBeGreaterThan(50);
    expect(outcome).toEqual(await undisturbed(setup));
  });
});
