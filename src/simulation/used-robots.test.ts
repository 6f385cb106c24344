/** The effect of the *reality* slider at its middle: which of the solutions in courses/ still succeed. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { parseScene } from '#scene/parse';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

const REALITY = 0.5;

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

interface Drive {
  readonly folder: string;
  /** Which used robot. */
  readonly seed: number;
  readonly forMs: number;
  /** A line of the pupil's, after the import of the library. */
  readonly line?: string;
}

/** True if the course's own solution passes its task on a used robot. */
async function passes({ folder, seed, forMs, line = '' }: Drive): Promise<boolean> {
  const parsed = parseScene(readFileSync(`courses/${folder}/scene.json`, 'utf8'));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const solution = readFileSync(`courses/${folder}/main.py`, 'utf8');
  const files = { 'main.py': solution.replace('from mbrobot import *\n', `from mbrobot import *\n${line}\n`) };
  const setup = { scene: parsed.scene, files, robot: 'auto', board: 'auto', seed, reality: REALITY };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  simulation.advanceTo(forMs * 1000);
  return simulation.verdict?.state === 'passed';
}

describe(`used robots (reality ${REALITY})`, { timeout: 60_000 }, () => {
  it.each([
    { folder: 'closed-line', seed: 1, forMs: 25_000 },
    { folder: 'corners', seed: 2, forMs: 30_000 },
    { folder: 'parking', seed: 3, forMs: 12_000 },
    { folder: 'push', seed: 4, forMs: 9_000 },
    { folder: 'gate', seed: 3, forMs: 14_000 },
    { folder: 'gate', seed: 5, forMs: 14_000 },
    { folder: 'bumper-maze', seed: 2, forMs: 60_000 },
    { folder: 'bumper-maze', seed: 5, forMs: 60_000 },
  ])('still do the task of $folder, which is solved with sensors (seed $seed)', async (drive) => {
    expect(await passes(drive)).toBe(true);
  });

  it.each([
    { folder: 'square', seed: 1, forMs: 16_000, line: 'calibrate(0, 3)' },
    { folder: 'square', seed: 2, forMs: 16_000, line: 'calibrate(0, -2)' },
    { folder: 'carry', seed: 1, forMs: 12_000, line: 'calibrate(0, 3)' },
  ])('miss $folder, which counts on straight ways, and do it with $line (seed $seed)', async (drive) => {
    expect(await passes({ ...drive, line: '' })).toBe(false);
    expect(await passes(drive)).toBe(true);
  });
});
