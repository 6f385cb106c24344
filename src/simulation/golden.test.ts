import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { parseScene } from '#scene/parse';
import { Simulation } from './simulation';

/** The recorded runs: courses/golden.json, made by `npm run courses:record`. */
interface Golden {
  readonly folder: string;
  readonly forMs: number;
  readonly seed: number;
  readonly traceHash: string;
}

const read = (path: string): string => readFileSync(`courses/${path}`, 'utf8');
const { runs } = JSON.parse(read('golden.json')) as { readonly runs: readonly Golden[] };

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

async function replay({ folder, forMs, seed }: Golden): Promise<Simulation> {
  const parsed = parseScene(read(`${folder}/scene.json`));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const files = { 'main.py': read(`${folder}/main.py`) };
  const setup = { scene: parsed.scene, files, robot: 'auto', board: 'auto', seed, reality: 0, keepTrace: true };
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(forMs * 1000);
  return simulation;
}

describe('a recorded run', () => {
  it.each(runs)('of $folder is the same to the last bit', { timeout: 60_000 }, async (golden) => {
    expect((await replay(golden)).traceHash).toBe(golden.traceHash);
  });

  const courses = runs.filter(({ folder }) => !folder.startsWith('golden/'));
  it.each(courses)('of $folder stays near its recording, and without an error', { timeout: 60_000 }, async (golden) => {
    const simulation = await replay(golden);
    expect(simulation.ended?.exception ?? null).toBeNull();
    const { tolerance, rows } = parseExpected(read(`${golden.folder}/expected.csv`));
    expect(rows.length).toBeLessThan(200);
    for (const [timeMs, xMm, yMm, headingDeg] of rows) {
      const row = simulation.trace[timeMs / 20];
      if (!row) throw new Error(`The run has no row for ${timeMs} ms.`);
      expect(Math.abs(row.xMm - xMm), `x at ${timeMs} ms`).toBeLessThanOrEqual(tolerance.x_mm);
      expect(Math.abs(row.yMm - yMm), `y at ${timeMs} ms`).toBeLessThanOrEqual(tolerance.y_mm);
      const turnedDeg = (row.headingRad * 180) / Math.PI - headingDeg;
      expect(Math.abs(turnedDeg - 360 * Math.round(turnedDeg / 360))).toBeLessThanOrEqual(tolerance.heading_deg);
    }
  });
});

describe('the ready courses', () => {
  it('are mastered: the line for two laps and more, the maze to the finish, neither with a collision', async () => {
    const [, line, maze] = runs;
    const onLine = (await replay(line!)).snapshot().robot;
    expect(onLine!.turnedRad / (2 * Math.PI)).toBeGreaterThan(2);
    expect(onLine!.collisions).toBe(0);
    const inMaze = await replay(maze!);
    expect(inMaze.ended?.kind).toBe('finished');
    expect(inMaze.snapshot().robot).toMatchObject({ collisions: 0 });
    expect(inMaze.snapshot().robot!.pose.xMm).toBeLessThan(200);
    expect(inMaze.snapshot().robot!.pose.yMm).toBeGreaterThan(620);
  }, 60_000);
});

/** The first line states the tolerances, the second the columns. */
function parseExpected(csv: string) {
  const [stated = '', , ...rows] = csv.trim().split('\n');
  const figure = (name: string): number => Number(new RegExp(`${name} ([\\d.]+)`).exec(stated)?.[1]);
  return {
    tolerance: { x_mm: figure('x_mm'), y_mm: figure('y_mm'), heading_deg: figure('heading_deg') },
    rows: rows.map((row) => row.split(',').map(Number) as [number, number, number, number]),
  };
}
