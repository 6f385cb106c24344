import type { Point } from '../src/scene/scene';
import { paintOf, trailOf } from './arena';
import { expect, test, type App } from './app';
import { distance, drive, ends, PATIENCE, sceneOf } from './course';
import { consoleIn, isThere, type Shown } from './page';

/** The robot comes by all these places, in any order, and what is said holds wherever it is seen. */
async function comesBy(app: App, places: readonly Point[], nearMm: number, always: (at: Shown) => void): Promise<void> {
  await expect
    .poll(async () => {
      const way = await trailOf(app);
      return places.filter((place) => way.every((at) => distance(at, place) > nearMm));
    }, PATIENCE)
    .toEqual([]);
  (await trailOf(app)).forEach(always);
  expect(await consoleIn(app)).not.toContain('Traceback');
}

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
      const way = await trailOf(app);
      const reach = (of: (at: Shown) => number): number => Math.max(...way.map(of)) - Math.min(...way.map(of));
      return reach(({ xMm }) => xMm) > width / 3 && reach(({ yMm }) => yMm) > height / 3;
    }, PATIENCE)
    .toBe(true);
  for (const { xMm, yMm } of await trailOf(app))
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
  const blocks: readonly Point[] = sceneOf('obstacles').objects.flatMap((it) =>
    it.type === 'fixed-block' ? [it.at] : [],
  );
  const places: readonly Point[] = [
    [150, 600],
    [500, 600],
    [980, 570],
    [1250, 370],
  ];
  await comesBy(app, places, 160, (at) => {
    for (const block of blocks) expect(distance(at, block)).toBeGreaterThan(70);
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
