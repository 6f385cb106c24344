import type { Point } from '../src/scene/scene';
import { robotAt, watchTrail, trailOf } from './arena';
import { expect, type App } from './app';
import { distance, PATIENCE } from './course';
import { consoleIn, isEnabled, on, pasteProgram, programIn, robotIn } from './page';
import { by, gone, until } from './parts';
import { canRedo, canUndo, clearAll, listOf, mainMenu, openEditor, type Pupil } from './pupil';
import { pickFile, savedFiles, watchSaving } from './transfer';

/** A track with round corners, counter-clockwise from where the robot of a first visit stands; every place on the grid of the keys. */
export const TRACK: readonly Point[] = roundedTrack([160, 130], [640, 610], 240, [400, 130]);

function roundedTrack([left, low]: Point, [right, high]: Point, radius: number, start: Point): readonly Point[] {
  const corner = (x: number, y: number, fromDeg: number): readonly Point[] =>
    Array.from({ length: 10 }, (_, i) => {
      const rad = ((fromDeg + i * 10) * Math.PI) / 180;
      return [tens(x + radius * Math.cos(rad)), tens(y + radius * Math.sin(rad))];
    });
  return [
    start,
    ...corner(right - radius, low + radius, -90),
    ...corner(right - radius, high - radius, 0),
    ...corner(left + radius, high - radius, 90),
    ...corner(left + radius, low + radius, 180),
    start,
  ];
}

function tens(mm: number): number {
  return Math.round(mm / 10) * 10;
}

/** Draws a track for a line, starts the program of a first visit, and sees that the robot goes round on it. */
export async function drawTrackAndFollow(pupil: Pupil): Promise<void> {
  const { app } = pupil;
  await openEditor(app);
  await clearAll(app);
  await pupil.chooseTool('pen');
  await pupil.draw(TRACK);
  await expect.poll(() => app.text(by('editor-said'))).toMatch(/^Line drawn, 1\d\d/);
  expect(await listOf(app)).toHaveLength(2); // the robot's start and the line
  await watchTrail(app);
  await app.click(on('run'));
  const sides: readonly Point[] = [
    [640, 370],
    [400, 610],
    [160, 370],
  ];
  await expect
    .poll(async () => {
      const way = await trailOf(app);
      return sides.filter((side) => way.every((at) => distance(at, side) > 80));
    }, PATIENCE)
    .toEqual([]);
  const far = (await trailOf(app)).filter((at) => fromTrack([at.xMm, at.yMm]) > 45);
  expect(far).toEqual([]);
  expect(await consoleIn(app)).not.toContain('Traceback');
}

/** How far a place is from the middle of the track, mm. */
function fromTrack([x, y]: Point): number {
  return Math.min(
    ...TRACK.slice(1).map(([x2, y2], i) => {
      const [x1, y1] = TRACK[i] ?? [x2, y2];
      const [dx, dy] = [x2 - x1, y2 - y1];
      const along = Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy || 1)));
      return Math.hypot(x - x1 - along * dx, y - y1 - along * dy);
    }),
  );
}

/** Edges of the grid of the maze, each in its middle; the first one is in the robot's path. No two lie in line. */
const EDGES: readonly Point[] = [
  [600, 80],
  [380, 300],
  [750, 220],
  [680, 450],
  [450, 520],
  [820, 600],
  [900, 380],
  [220, 750],
];

/** Drives straight on for longer than it takes to come to any wall. */
export const STRAIGHT_ON =
  'from mbrobot import *\nsetSpeed(40)\nforward()\ndelay(8000)\nstop()\nprint("there: the robot stands")';

/** Puts up walls in an empty arena, on edges of a maze's grid. */
export async function buildMaze(pupil: Pupil, walls: number): Promise<void> {
  await openEditor(pupil.app);
  await clearAll(pupil.app);
  await pupil.chooseTool('maze');
  for (const edge of EDGES.slice(0, walls)) await pupil.draw([edge]);
}

/** Builds a maze of eight walls and sees that the robot runs into the one in front of it. */
export async function buildMazeAndMeetWall(pupil: Pupil): Promise<void> {
  const { app } = pupil;
  await buildMaze(pupil, EDGES.length);
  const rows = await listOf(app);
  expect(rows.slice(1).map((row) => row.replace(/from.*/, ''))).toEqual(EDGES.map((_, i) => `Wall ${i + 1}`));
  await pasteProgram(app, STRAIGHT_ON);
  await app.click(on('run'));
  await meetsWall(app);
}

/** The robot has driven to the wall in front of it, and no farther, when its program has said so. */
export async function meetsWall(app: App, said = 'there: the robot stands'): Promise<void> {
  await expect.poll(() => consoleIn(app)).toContain(said);
  await app.click(on('stop'));
  await expect.poll(() => isEnabled(app, 'stop')).toBe(false);
  await expect.poll(async () => (await robotAt(app)).xMm).toBeGreaterThan(450);
  expect((await robotAt(app)).xMm).toBeLessThan(600);
}

/** Moves and turns the start; the robot sets out from there and comes back there. */
export async function moveStart(pupil: Pupil): Promise<void> {
  const { app } = pupil;
  await openEditor(app);
  await pupil.chooseTool('start');
  await pupil.draw([
    [300, 500],
    [300, 400],
    [300, 300],
  ]);
  const start = { xMm: 300, yMm: 500, headingDeg: -90 };
  await expect.poll(() => robotIn(app)).toEqual(start);
  await expect.poll(() => app.text(by('editor-said'))).toContain('Start at 30 | 50 cm');
  await pasteProgram(app, 'from mbrobot import *\nforward()');
  await app.click(on('run'));
  await expect.poll(async () => (await robotIn(app)).yMm).toBeLessThan(400);
  expect(Math.abs((await robotIn(app)).xMm - 300)).toBeLessThan(5);
  await app.click(on('reset'));
  await expect.poll(() => robotIn(app)).toEqual(start);
}

/** Takes five steps of five tools back, one by one, and does them again. */
export async function undoFiveSteps(pupil: Pupil, undo: () => Promise<void>, redo: () => Promise<void>): Promise<void> {
  const { app } = pupil;
  await openEditor(app);
  const steps: readonly { readonly tool: string; readonly places: readonly Point[]; readonly said: string }[] = [
    { tool: 'pen', places: [[500, 300], [600, 300], [700, 300]], said: 'Line drawn' }, // prettier-ignore
    { tool: 'wall', places: [[500, 400], [600, 400], [700, 400]], said: 'Wall added' }, // prettier-ignore
    { tool: 'block', places: [[600, 500]], said: 'Block added' },
    { tool: 'zone', places: [[300, 400]], said: 'Target added' },
    { tool: 'start', places: [[800, 300]], said: 'Start at 80 | 30' },
  ];
  const lists = [await listOf(app)];
  for (const { tool, places, said } of steps) {
    await pupil.chooseTool(tool);
    await pupil.draw(places);
    await expect.poll(() => app.text(by('editor-said'))).toContain(said);
  }
  const built = await listOf(app);
  expect(built).toHaveLength((lists[0] ?? []).length + 4);
  for (const { said } of [...steps].reverse()) {
    expect(await canUndo(app)).toBe(true);
    await undo();
    await expect.poll(() => app.text(by('editor-said'))).toContain(`Undone: ${said}`);
  }
  expect(await canUndo(app)).toBe(false);
  expect(await listOf(app)).toEqual(lists[0]);
  for (const { said } of steps) {
    expect(await canRedo(app)).toBe(true);
    await redo();
    await expect.poll(() => app.text(by('editor-said'))).toContain(`Redone: ${said}`);
  }
  expect(await canRedo(app)).toBe(false);
  expect(await listOf(app)).toEqual(built);
}

/** Saves a project, finds it again after a reload, throws all away and loads it. */
export async function saveReloadLoad(pupil: Pupil): Promise<void> {
  const { app } = pupil;
  await buildMaze(pupil, 1);
  await pasteProgram(app, 'print("mine")');
  const rows = await listOf(app);
  expect(rows).toHaveLength(2);
  await watchSaving(app);
  await mainMenu(app, 'save');
  await expect.poll(async () => (await savedFiles(app)).length).toBe(1);
  const [file] = await savedFiles(app);
  if (file === undefined) throw new Error('Nothing was saved.');
  expect(file.name).toMatch(/\.parcours\.json$/);

  await app.reload();
  await expect.poll(() => programIn(app)).toBe('print("mine")');
  expect(await listOf(app)).toEqual(rows);
  expect(await canUndo(app)).toBe(true); // what was built before can still be taken back

  await clearAll(app);
  expect(await listOf(app)).toHaveLength(1);
  await pasteProgram(app, 'print("other")');
  await pickFile(app, file);
  await mainMenu(app, 'open');
  await until(app, by('open-files'));
  await app.click(by('open-files'));
  await expect.poll(() => programIn(app)).toBe('print("mine")');
  expect(await listOf(app)).toEqual(rows);
}

/** The link to the project that is open, out of the dialog. */
export async function linkFrom(app: App): Promise<string> {
  await app.click(by('share'));
  await until(app, by('share-link'));
  const link = await app.evaluate(
    (css) => document.querySelector<HTMLInputElement>(css)?.value ?? '',
    by('share-link'),
  );
  await app.click(by('share-close'));
  await gone(app, by('share-dialog'));
  return link;
}

/** Shares a maze and its program by link; another pupil, who has nothing of it, has them all. */
export async function shareWith(pupil: Pupil, another: () => Promise<Pupil>): Promise<void> {
  await buildMaze(pupil, 1);
  await pasteProgram(pupil.app, STRAIGHT_ON);
  const rows = await listOf(pupil.app);
  expect(rows).toHaveLength(2);
  const link = await linkFrom(pupil.app);
  expect(link).toContain('#p=');
  const { app: other } = await another(); // a window that opens earlier would take the keyboard away
  await openEditor(other);
  expect(await listOf(other)).not.toEqual(rows);
  await other.goto(link);
  await expect.poll(() => programIn(other)).toBe(STRAIGHT_ON);
  expect(await listOf(other)).toEqual(rows);
  await other.click(on('run'));
  await meetsWall(other);
}
