import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { randomMaze } from '#scene/random/maze';
import { randomTrack } from '#scene/random/track';
import type { Scene } from '#scene/scene';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';
import type { Verdict } from './task/verdict';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const words = { name: '', description: '' };

/** The result of a random course when a ready course's solution drives in it, for at most this many simulated s. */
async function drive(scene: Scene, course: string, seconds: number): Promise<Verdict | null> {
  const files = { 'main.py': readFileSync(`courses/${course}/main.py`, 'utf8') };
  const setup = { scene, files, robot: 'auto', board: 'auto', seed: 1, reality: 0, keepTrace: false };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  for (let second = 1; second <= seconds && simulation.verdict?.state === 'open'; second += 1)
    simulation.advanceTo(second * 1_000_000);
  return simulation.verdict;
}

describe('the left hand on the wall', { timeout: 60_000 }, () => {
  it.each([
    { seed: 1, columns: 4, rows: 3 },
    { seed: 2, columns: 4, rows: 3 },
    { seed: 3, columns: 5, rows: 4 },
    { seed: 4, columns: 5, rows: 4 },
    { seed: 5, columns: 6, rows: 4 },
    { seed: 4711, columns: 8, rows: 6 },
  ])('finds the target of the random maze $seed, $columns × $rows cells, without a touch', async (wish) => {
    const verdict = await drive(randomMaze({ ...wish, cellMm: 250 }, words), 'large-maze', 400);
    expect(verdict).toMatchObject({ state: 'passed', touches: 0 });
  });
});

describe('the line follower for tight bends', { timeout: 60_000 }, () => {
  it.each([
    { seed: 1, bends: 6, size: [1200, 900] },
    { seed: 2, bends: 6, size: [1200, 900] },
    { seed: 3, bends: 9, size: [1600, 1200] },
    { seed: 4, bends: 9, size: [1600, 1200] },
    { seed: 5, bends: 14, size: [2000, 1400] },
    { seed: 4711, bends: 14, size: [2000, 1400] },
  ] as const)('drives a lap of the random track $seed with $bends bends or more', async (wish) => {
    const verdict = await drive(randomTrack(wish, words), 's-bends', 120);
    expect(verdict).toMatchObject({ state: 'passed', checkpoints: { passed: 3, of: 3 }, touches: 0 });
  });
});
