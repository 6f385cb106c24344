import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';
import type { Snapshot } from './snapshot';
import { convoyOf } from './testing/convoy';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

const runOf = (files: Readonly<Record<string, string>>) =>
  soloRun({ scene: defaultScene(), files, robot: 'maqueen-lite', board: 'microbit-v2', seed: 1, reality: 0 });

/** The positions of a program, every 20 ms. */
async function positions(files: Readonly<Record<string, string>>, untilUs = 1_000_000) {
  const seen: (string | null)[] = [];
  const note = ({ position: at }: Snapshot): number => seen.push(at && `${at.file}:${at.line} (${at.depth})`);
  const simulation = await Simulation.create(runOf(files), firmware, { moment: note });
  simulation.advanceTo(untilUs);
  return seen;
}

describe('a snapshot', () => {
  it("says in which line of the pupil's the program is, also while the library or a driver works for it", async () => {
    const main = 'from mbrobot import *\nimport far\nforward()\ndelay(300)\nfar.wait()\nprint(1)';
    const seen = await positions({ 'main.py': main, 'far.py': 'def wait():\n    delay(200)\nfrom mbrobot import *' });
    const distinct = seen.filter((each, place) => each !== seen[place - 1]);
    expect(distinct.slice(-3)).toEqual(['main.py:4 (0)', 'far.py:2 (1)', null]);
  });

  it('says so of a program that prints, calls itself, and ends by an error', async () => {
    const main =
      'from microbit import *\ndef deep(n):\n    if n == 0:\n        sleep(100)\n        return 1 // n\n    return deep(n - 1)\ndeep(3)';
    const seen = await positions({ 'main.py': main });
    expect(seen).toContain('main.py:4 (4)');
    expect(seen.at(-1)).toBeNull();
  });

  it('says so of each device', async () => {
    const simulation = await Simulation.create(convoyOf(3), firmware);
    simulation.advanceTo(500_000);
    const { position, others } = simulation.snapshot();
    for (const each of [position, ...others.map((other) => other.position)]) expect(each?.file).toBe('main.py');
  });
});
