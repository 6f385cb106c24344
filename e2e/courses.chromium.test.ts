import { readFileSync } from 'node:fs';
import { parseScene } from '../src/scene/parse';
import type { Point } from '../src/scene/scene';
import { middleOf, paintOf, robotAt, watchWay, wayOf } from './arena';
import { expect, test, type App } from './app';
import { consoleIn, isThere, on, openApp, programIn, type Shown } from './page';

/** The ready courses, each opened from the list and driven by its own program in the page, at full speed. */
const read = (path: string): string => readFileSync(new URL(`../courses/${path}`, import.meta.url), 'utf8');

function sceneOf(folder: string) {
  const parsed = parseScene(read(`${folder}/scene.json`));
  if (!('scene' in parsed)) throw new Error(`${folder}/scene.json cannot be read.`);
  return parsed.scene;
}

/** Opens a course as a pupil does, and starts its program. */
async function drive(app: App, folder: string, robot: string): Promise<void> {
  const { en } = JSON.parse(read(`${folder}/texts.json`)) as { readonly en: { readonly name: string } };
  await openApp(app, { language: 'en', speed: 'max', cone: false });
  await app.click('header .course');
  await expect.poll(() => isThere(app, '.courses')).toBe(true);
  const place = await app.evaluate((name) => {
    const items = Array.from(document.querySelectorAll('.courses > *'));
    return 1 + items.findIndex((item) => item.querySelector('.v-list-item-title')?.textContent === name);
  }, en.name);
  expect(place, `${en.name} in the list`).toBeGreaterThan(0);
  await app.click(`.courses > :nth-child(${String(place)})`);
  await expect.poll(() => programIn(app)).toBe(read(`${folder}/main.en.py`).trimEnd());
  expect(await app.text('.pane-arena .pane-head')).toContain(robot);
  expect(await isThere(app, '[data-testid=misplugged]')).toBe(false);
  await watchWay(app);
  await app.click(on('run'));
}

const PATIENCE = { timeout: 60_000 };

/** The program has come to its end, without an error, and the robot is where it is in the course's recording. */
async function ends(app: App, folder: string): Promise<void> {
  await expect.poll(() => consoleIn(app), PATIENCE).toContain('The program has ended.');
  const [, x = NaN, y = NaN] = (read(`${folder}/expected.csv`).trim().split('\n').at(-1) ?? '').split(',').map(Number);
  await expect.poll(async () => distance(await robotAt(app), [x, y])).toBeLessThan(12);
}

/** The robot comes by all these places, in any order, and what is said holds wherever it is seen. */
async function comesBy(app: App, places: readonly Point[], nearMm: number, always: (at: Shown) => void): Promise<void> {
  await expect
    .poll(async () => {
      const way = await wayOf(app);
      return places.filter((place) => way.every((at) => distance(at, place) > nearMm));
    }, PATIENCE)
    .toEqual([]);
  (await wayOf(app)).forEach(always);
  expect(await consoleIn(app)).not.toContain('Traceback');
}

const distance = ({ xMm, yMm }: Shown, [x, y]: Point): number => Math.hypot(xMm - x, yMm - y);

/** From the middle of a line, as on the floor. */
function fromLine(at: Shown, points: readonly Point[]): number {
  return Math.min(...points.slice(1).map((to, i) => fromPiece(at, points[i] ?? to, to)));
}

function fromPiece(at: Shown, [x1, y1]: Point, [x2, y2]: Point): number {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const along = ((at.xMm - x1) * dx + (at.yMm - y1) * dy) / (dx * dx + dy * dy);
  const share = Math.min(1, Math.max(0, along));
  return distance(at, [x1 + share * dx, y1 + share * dy]);
}

function lineOf(folder: string): readonly Point[] {
  const line = sceneOf(folder).objects.find(({ id }) => id === 'line');
  if (line?.type !== 'stroke') throw new Error(`${folder} has no line.`);
  return line.points;
}

test('the empty arena: the robot keeps clear of all four walls', async ({ app }) => {
  await drive(app, 'empty', 'Maqueen Lite');
  const [width, height] = sceneOf('empty').size;
  await expect
    .poll(async () => {
      const way = await wayOf(app);
      const reach = (of: (at: Shown) => number): number => Math.max(...way.map(of)) - Math.min(...way.map(of));
      return reach(({ xMm }) => xMm) > width / 3 && reach(({ yMm }) => yMm) > height / 3;
    }, PATIENCE)
    .toBe(true);
  for (const { xMm, yMm } of await wayOf(app))
    expect(Math.min(xMm, width - xMm, yMm, height - yMm)).toBeGreaterThan(80);
  expect(await consoleIn(app)).not.toContain('Traceback');
});

test('the closed line: the robot comes round on it', async ({ app }) => {
  await drive(app, 'closed-line', 'Maqueen Lite');
  const line = lineOf('closed-line');
  const sides: readonly Point[] = [
    [1070, 450],
    [600, 686],
    [130, 450],
    [600, 130],
  ];
  await comesBy(app, sides, 200, (at) => expect(fromLine(at, line)).toBeLessThan(25));
});

test('the line with corners: the robot takes every corner, to the left and to the right', async ({ app }) => {
  await drive(app, 'corners', 'Maqueen Plus V2');
  const line = lineOf('corners');
  await comesBy(app, line, 160, (at) => expect(fromLine(at, line)).toBeLessThan(15));
});

test('the obstacles: the robot finds its way past them', async ({ app }) => {
  await drive(app, 'obstacles', 'Maqueen Lite');
  const blocks: readonly Point[] = sceneOf('obstacles').objects.flatMap((it) => ('at' in it ? [it.at] : []));
  const places: readonly Point[] = [
    [200, 590],
    [550, 550],
    [780, 440],
  ];
  await comesBy(app, places, 130, (at) => {
    for (const block of blocks) expect(distance(at, block)).toBeGreaterThan(80);
  });
});

test('clear the ring: three blocks lie outside when the program is through', async ({ app }) => {
  await drive(app, 'clear-the-ring', 'Maqueen Lite');
  await ends(app, 'clear-the-ring');
  expect(await consoleIn(app)).toContain('pushed out: 3');
  const painted = await paintOf(app, 'blocks', sceneOf('clear-the-ring').size);
  expect(painted.length).toBeGreaterThan(0);
  const inside = painted.filter(({ x, y }) => Math.hypot(x - 500, y - 500) < 380 - 25);
  expect(inside).toEqual([]);
});

test('the maze with a bumper: the Calli:bot comes to the black line by touch', async ({ app }) => {
  await drive(app, 'bumper-maze', 'Calli:bot');
  await ends(app, 'bumper-maze');
  expect(await isThere(app, '.pane-arena .half')).toBe(true); // what the bumper feels, under the arena
});

test('the small maze: the robot comes to the black line', async ({ app }) => {
  await drive(app, 'small-maze', 'Maqueen Lite');
  await ends(app, 'small-maze');
});

test('carry the block: it lies in the field, the robot has let go of it', async ({ app }) => {
  await drive(app, 'carry', 'Maqueen Lite');
  await ends(app, 'carry');
  const { x, y } = middleOf(await paintOf(app, 'blocks', sceneOf('carry').size));
  expect(distance(await robotAt(app), [x, y])).toBeGreaterThan(150);
  expect([Math.abs(x - 1000) < 80, Math.abs(y - 650) < 70], `the block lies at ${x}, ${y}`).toEqual([true, true]);
});
