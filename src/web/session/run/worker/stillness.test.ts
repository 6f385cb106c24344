import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

import { createStillness } from './stillness';

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));

/** True if everything is at rest, five seconds after a robot began to drive against the edge of the arena. */
async function isStillAfter(program: string): Promise<boolean> {
  const files = { 'main.py': `from mbrobot import *\n${program}` };
  const setup = { scene: defaultScene(), files, robot: 'maqueen-lite', board: 'auto', seed: 1, reality: 0 };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  const stillness = createStillness();
  let isStill = false;
  for (let ms = 100; ms <= 5000; ms += 100) {
    simulation.advanceTo(ms * 1000);
    isStill = stillness.look(simulation.snapshot());
  }
  return isStill;
}

describe('a world in which nothing moves', () => {
  it('has a robot in it that pushes against the edge for ever, its wheels blocked', async () => {
    expect(await isStillAfter('forward()')).toBe(true);
  });

  it('has none whose wheels spin there: they are seen to turn, and the REPL may ask how far', async () => {
    expect(await isStillAfter('setSpeed(100)\nforward()')).toBe(false);
  });

  it('has none that drives in a circle', async () => {
    expect(await isStillAfter('leftArc(0.1)')).toBe(false);
  });
});
