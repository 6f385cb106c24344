import { readFileSync } from 'node:fs';
import { parseScene } from '../src/scene/parse';
import { expect, test } from './app';

/** The recorded trajectories: the same list that the unit tests compare in Node. */
interface GoldenRun {
  readonly folder: string;
  readonly forMs: number;
  readonly seed: number;
  readonly traceHash: string;
}

const read = (path: string): string => readFileSync(new URL(`../courses/${path}`, import.meta.url), 'utf8');
const { runs } = JSON.parse(read('golden.json')) as { readonly runs: readonly GoldenRun[] };
const PROBE = process.env['PARCOURS_PROBE'] ?? '';

for (const { folder, forMs, seed, traceHash } of runs) {
  test(`${folder} is driven bit for bit as in Node`, async ({ app }) => {
    const parsed = parseScene(read(`${folder}/scene.json`));
    if (!('scene' in parsed)) throw new Error(`${folder}/scene.json cannot be read.`);
    const files = { 'main.py': read(`${folder}/main.py`) };
    const setup = { scene: parsed.scene, files, robot: 'auto', board: 'auto', seed, reality: 0 };
    await app.goto(PROBE);
    const result = await app.evaluate(({ run, untilMs }) => window.probe(run, untilMs), { run: setup, untilMs: forMs });
    expect(result.traceHash).toBe(traceHash);
  });
}
