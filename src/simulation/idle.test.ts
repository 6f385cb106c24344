import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Switching } from '#scene/kinds/switching';
import { defaultScene, type Barrier } from '#scene/scene';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));

/** True if nothing is set for later, so many seconds after the start. */
async function isIdleAfter(
  seconds: number,
  program: string,
  limit: number | null = null,
  robot = 'auto',
): Promise<boolean> {
  const scene = { ...defaultScene(), task: { seconds: limit, noTouch: false } };
  const setup = { scene, files: { 'main.py': program }, robot, board: 'auto', seed: 1, reality: 1 };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  simulation.advanceTo(seconds * 1_000_000);
  return simulation.isIdle;
}

describe('a run is idle', () => {
  it.each([
    ['none', 'from microbit import *\ndisplay.show(7)'],
    ['maqueen-lite', 'from mbrobot import *\nforward()\ndelay(500)\nstop()\nprint(getDistance())'],
    ['maqueen-plus-v2', 'from mbrobot_plusV2 import *\nforward()\ndelay(500)\nstop()\nprint(getDistance())'],
    ['callibot', 'from callibot import *\nforward()\ndelay(500)\nstop()\nprint(getDistance())'],
  ])('when the program has ended, robot: %s', async (robot, program) => {
    expect(await isIdleAfter(3, program, null, robot)).toBe(true);
  });

  it('not while the program runs', async () => {
    expect(await isIdleAfter(3, 'while True: pass')).toBe(false);
  });

  it.each([
    [
      'pictures change in the background',
      'from microbit import *\ndisplay.show("AB", delay=9000, wait=False, loop=True)',
    ],
    ['a melody plays in the background', 'import music\nmusic.play(["c4:64"], wait=False, loop=True)'],
  ])('not when the program has ended but %s', async (_, program) => {
    expect(await isIdleAfter(3, program)).toBe(false);
  });

  it('not while time switches a lamp or a barrier', async () => {
    const gate = (opens: Switching): Barrier => ({ type: 'barrier', id: 'b', from: [900, 0], to: [900, 900], thickness: 10, opens }); // prettier-ignore
    const isIdleWith = async (opens: Switching) => {
      const scene = { ...defaultScene(), objects: [gate(opens)] };
      const setup = { scene, files: { 'main.py': 'pass' }, robot: 'auto', board: 'auto', seed: 1, reality: 0 };
      const simulation = await Simulation.create(soloRun(setup), firmware);
      simulation.advanceTo(3_000_000);
      return simulation.isIdle;
    };
    expect(await isIdleWith({ time: [3, 3] })).toBe(false);
    expect(await isIdleWith('hand')).toBe(true);
  });

  it('not while time will decide the task', async () => {
    expect(await isIdleAfter(3, 'pass', 5)).toBe(false);
    expect(await isIdleAfter(6, 'pass', 5)).toBe(true);
  });
});
