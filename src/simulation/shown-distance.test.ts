import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parseSceneValue } from '#scene/parse';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));

/** Distances from 45 cm to the wall itself: as the program reads them, and as the page shows them, in cm. */
async function distances(library: string, robot: string): Promise<{ read: number; shown: number }[]> {
  const wall = { id: 'w', type: 'wall', from: [800, 100], to: [800, 800] };
  const parsed = parseSceneValue({ format: 'parcours-scene', version: 1, robot: { at: [300, 450] }, objects: [wall] });
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const program = `from ${library} import *\nwhile True:\n    print(getDistance())\n    delay(20)`;
  const files = { 'main.py': program };
  const simulation = await Simulation.create(
    soloRun({ scene: parsed.scene, files, robot, board: 'auto', seed: 1, reality: 0 }),
    firmware,
  );
  const found = [];
  for (let xMm = 300; xMm < 755; xMm += 13.1) {
    simulation.input({ type: 'place', pose: { xMm, yMm: 450, headingDeg: 0 } });
    simulation.advanceTo(simulation.nowUs + 500_000);
    const read = Number(simulation.takeConsole().trim().split('\n').at(-1));
    const shown = simulation.snapshot().robot?.state.ultrasonic?.distanceMm ?? NaN;
    found.push({ read, shown: shown / 10 });
  }
  return found;
}

describe('the distance on the page', () => {
  it.each([
    ['mbrobot', 'maqueen-lite'],
    ['mbrobot_plusV2', 'maqueen-plus-v2'],
    ['callibot', 'callibot'],
  ])('is the one that a program reads, 2 cm at the wall: %s', async (library, robot) => {
    const found = await distances(library, robot);
    for (const { read, shown } of found) expect(Math.abs(shown - read)).toBeLessThanOrEqual(0.51); // whole cm
    expect(found.at(-1)).toEqual({ read: 2, shown: 2 });
    expect(Math.max(...found.map(({ read }) => read))).toBeGreaterThan(30);
  });
});
