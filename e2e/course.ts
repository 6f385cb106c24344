import { existsSync, readFileSync } from 'node:fs';
import { parseScene } from '../src/scene/parse';
import type { Point, Scene } from '../src/scene/scene';
import { robotAt, watchTrail } from './arena';
import { expect, type App } from './app';
import { consoleIn, isThere, on, openApp, programIn, robotName, type Shown } from './page';
import { by, gone, until } from './parts';

const fileOf = (path: string): URL => new URL(`../courses/${path}`, import.meta.url);

/** The text of a file in `courses/`. */
const read = (path: string): string => readFileSync(fileOf(path), 'utf8');

/** The arena of a ready course. */
export function sceneOf(folder: string): Scene {
  const parsed = parseScene(read(`${folder}/scene.json`));
  if (!('scene' in parsed)) throw new Error(`${folder}/scene.json cannot be read.`);
  return parsed.scene;
}

/** Opens a ready course with its solution out of the gallery, as a pupil does, and starts it at full speed. */
export async function drive(app: App, folder: string, robot: string): Promise<void> {
  await openApp(app, { language: 'en', speed: 'max', cone: false });
  await app.click('header .course');
  await until(app, by('all-courses'));
  await app.click(by('all-courses'));
  await until(app, by(`course-${folder}`));
  await app.click(`${by(`course-${folder}`)} h3 a`);
  await until(app, '.gallery .sheet');
  if (existsSync(fileOf(`${folder}/start.py`))) {
    await app.click(by('show-solution'));
    await app.click(by('open-solved'));
  } else {
    await app.click(by(`open-${folder}`));
  }
  await gone(app, '.gallery');
  const top = read(`${folder}/main.py`).split('\n').slice(0, 8).join('\n'); // the editor has no lines that are out of sight
  await expect.poll(() => programIn(app)).toContain(top);
  await expect.poll(() => robotName(app)).toBe(robot);
  expect(await isThere(app, '[data-testid=misplugged]')).toBe(false);
  await expect.poll(async () => distance(await robotAt(app), sceneOf(folder).robot.at)).toBeLessThan(1); // no longer where the course before began
  await watchTrail(app);
  await app.click(on('run'));
}

/** A minute of simulated time at full speed, on a busy machine. */
export const PATIENCE = { timeout: 60_000 };

/** The record of a course in `courses/golden.json`. */
interface Recorded {
  readonly folder: string;
  readonly endMm: { readonly x: number; readonly y: number };
}

/** The program has come to its end, without an error, and the robot is where it is in the course's recording. */
export async function ends(app: App, folder: string): Promise<void> {
  await expect.poll(() => consoleIn(app), PATIENCE).toContain('The program has ended.');
  const { runs } = JSON.parse(read('golden.json')) as { readonly runs: readonly Recorded[] };
  const { x, y } = runs.find((run) => run.folder === folder)?.endMm ?? { x: NaN, y: NaN };
  await expect.poll(async () => distance(await robotAt(app), [x, y])).toBeLessThan(12);
}

/** From a place, in mm. */
export const distance = ({ xMm, yMm }: Shown, [x, y]: Point): number => Math.hypot(xMm - x, yMm - y);
