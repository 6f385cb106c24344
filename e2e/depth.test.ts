import { readFileSync } from 'node:fs';
import { defaultScene } from '../src/scene/scene';
import { expect, test } from './app';
import { soloRun } from '#simulation/run-setup';

const read = (name: string): string => readFileSync(new URL(`../src/vm/run/testing/${name}`, import.meta.url), 'utf8');
const PROBE = process.env['PARCOURS_PROBE'] ?? '';

test('calls may go as deep as in Node, and no deeper', async ({ app }) => {
  const files = { 'main.py': read('depth.py') };
  const setup = soloRun({ scene: defaultScene(), files, robot: 'none', board: 'auto', seed: 1, reality: 0 });
  await app.goto(PROBE);
  const result = await app.evaluate(({ run, untilMs }) => window.probe(run, untilMs), { run: setup, untilMs: 20_000 });
  expect(result.console).toBe(read('depth.txt'));
});
