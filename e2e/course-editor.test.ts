import { robotAt } from './arena';
import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import {
  buildMaze,
  buildMazeAndMeetWall,
  drawTrackAndFollow,
  linkFrom,
  meetsWall,
  moveStart,
  saveReloadLoad,
  shareWith,
  STRAIGHT_ON,
  undoFiveSteps,
} from './course-tasks';
import { attribute, consoleIn, enterMode, isEnabled, isThere, on, openApp, pasteProgram, programIn } from './page';
import { by, gone, until } from './parts';
import { build, canUndo, clearAll, courseMenu, fromMenu, listOf, openEditor, rowsIn, withMouse } from './pupil';

test('with the mouse: a track is drawn, and the robot follows it', async ({ app }) => {
  await drawTrackAndFollow(withMouse(app));
});

test(
  'with the mouse: a maze of eight walls is built, and the robot meets one of them',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await buildMazeAndMeetWall(withMouse(app));
  },
);

test(
  'with the mouse: the start is moved and turned, and the robot sets out from there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await moveStart(withMouse(app));
  },
);

test('with the mouse: five steps are taken back one by one, and done again', IN_ONE_ENGINE, async ({ app }) => {
  await undoFiveSteps(
    withMouse(app),
    () => app.click(by('undo')),
    () => app.click(by('redo')),
  );
});

test('with the mouse: a project is saved, is there after a reload, and is loaded', IN_ONE_ENGINE, async ({ app }) => {
  await saveReloadLoad(withMouse(app));
});

test('with the mouse: a link brings the project to another profile', IN_ONE_ENGINE, async ({ app, another }) => {
  await shareWith(withMouse(app), async () => withMouse(await another()));
});

/** Waits for the left sensor to see something dark, and drives straight on. */
const ON_DARK = STRAIGHT_ON.replace(
  'forward()',
  'print("begun")\nwhile irLeft.read_digital(): delay(20)\nprint("dark")\nforward()',
);

/** The bar at the arena's foot while changes wait for the next start. */
const WAITING = `${by('next-step')}[data-step=waiting]`;

/** Strokes to and fro over the floor below the sensors of a robot at the start of a first visit. */
const SCRIBBLE = Array.from({ length: 17 }, (_, i) => [400 + 10 * i, i % 2 === 0 ? 80 : 180] as const);

test(
  'a course is changed while its program runs: lines hold at once, walls from the next start on',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const pupil = withMouse(app);
    await openEditor(app);
    await clearAll(app);
    await pasteProgram(app, ON_DARK);
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('begun');

    await pupil.chooseTool('wall');
    await pupil.draw([[600, 20], [600, 150], [600, 250]]); // prettier-ignore
    await until(app, WAITING);
    expect(await consoleIn(app)).not.toContain('dark');
    await pupil.chooseTool('pen');
    await pupil.draw(SCRIBBLE);
    await enterMode(app, 'drive');
    await app.click(by('pause')); // building has paused it
    await expect.poll(() => consoleIn(app)).toContain('there: the robot stands');
    await expect.poll(async () => (await robotAt(app)).xMm).toBeGreaterThan(650); // where the wall is drawn, it is not yet
    expect((await consoleIn(app)).match(/begun/g)).toHaveLength(1);
    expect(await isEnabled(app, 'stop')).toBe(true);

    await app.click(by('step-restart'));
    await gone(app, WAITING);
    await expect.poll(async () => (await robotAt(app)).xMm).toBe(400);
    await pasteProgram(app, ON_DARK.replace('there', 'once more there')); // the console still has what the first run said
    await app.click(on('run'));
    await meetsWall(app, 'once more there');
  },
);

test('Escape drops what a tool has begun', IN_ONE_ENGINE, async ({ app }) => {
  const pupil = withMouse(app);
  await openEditor(app);
  await pupil.chooseTool('block');
  await app.grab(by('arena'));
  await app.press('Escape');
  await app.letGo();
  expect(await canUndo(app)).toBe(false);
  await app.grab(by('arena'));
  await app.letGo();
  await expect.poll(() => app.text(by('editor-said'))).toContain('Block added');
  expect(await canUndo(app)).toBe(true);
});

test('a damaged link gives a message and changes nothing', IN_ONE_ENGINE, async ({ app }) => {
  await buildMaze(withMouse(app), 1);
  await pasteProgram(app, 'print("mine")');
  const rows = await listOf(app);
  const link = await linkFrom(app);
  await app.goto(link.slice(0, -12));
  await expect.poll(() => app.text('.notice')).toContain('The link is damaged');
  expect(await programIn(app)).toBe('print("mine")');
  expect(await listOf(app)).toEqual(rows);
  await expect.poll(() => app.evaluate(() => location.hash)).toBe('');
});

test('a link that is opened keeps the work so far, one click away', IN_ONE_ENGINE, async ({ app }) => {
  const pupil = withMouse(app);
  await buildMaze(pupil, 1);
  await pasteProgram(app, 'print("of the link")');
  const [linked, link] = [await listOf(app), await linkFrom(app)];
  await clearAll(app);
  await pupil.chooseTool('block');
  await pupil.draw([[700, 400]]);
  await pasteProgram(app, 'print("mine")');
  const mine = await listOf(app);
  expect(mine).toHaveLength(2);

  await app.goto(link);
  await expect.poll(() => programIn(app)).toBe('print("of the link")');
  expect(await listOf(app)).toEqual(linked);
  await expect.poll(() => app.text('.notice')).toContain('Your work has been kept');
  await app.click('.notice .do');
  await expect.poll(() => programIn(app)).toBe('print("mine")');
  expect(await listOf(app)).toEqual(mine);
});

test(
  'a task of one’s own is passed; with a wall in the way and nothing to be touched it is failed',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const pupil = withMouse(app);
    await openEditor(app);
    await clearAll(app);
    await pupil.chooseTool('zone');
    await pupil.draw([[700, 130]]);
    await until(app, by('verdict'));
    expect(await attribute(app, by('verdict'), 'data-state')).toBe('open');
    await pasteProgram(app, STRAIGHT_ON);
    await app.click(on('run'));
    await expect.poll(() => app.text(by('verdict'))).toContain('Well done!');

    await app.click(by('verdict-again'));
    await expect.poll(() => attribute(app, by('verdict'), 'data-state')).toBe('open');
    await pupil.chooseTool('wall');
    await pupil.draw([[550, 20], [550, 150], [550, 250]]); // prettier-ignore
    await courseMenu(app, 'course');
    await until(app, by('no-touch'));
    await app.click(by('no-touch'));
    await app.click(`${by('panel-course')} .title button`);
    await gone(app, by('panel-course'));
    await app.click(on('run'));
    await expect.poll(() => app.text(by('verdict'))).toContain('The robot touched a wall.');
    expect(await attribute(app, by('verdict'), 'data-state')).toBe('failed');
  },
);

test(
  'in the list of objects a block is added, moved by numbers and deleted, and all of it taken back',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openEditor(app);
    await clearAll(app);
    await courseMenu(app, 'list');
    await until(app, by('add-object'));
    await fromMenu(app, by('add-object'), by('add-block'), () => isThere(app, '.detail .field input'));
    expect(await rowsIn(app)).toHaveLength(2);
    await app.fill('.detail .field input', '71.5');
    await app.press('Enter');
    await expect.poll(async () => (await rowsIn(app))[1]).toMatch(/^Block 1.* at 71\.5 \| /);
    await app.press('ArrowUp');
    await expect.poll(async () => (await rowsIn(app))[1]).toMatch(/ at 72\.5 \| /);
    await app.click('.detail .remove');
    await expect.poll(() => rowsIn(app)).toHaveLength(1);
    await app.click(`${by('panel-list')} .title button`);
    await gone(app, by('panel-list'));
    await app.click(by('undo'));
    await app.click(by('undo'));
    await expect.poll(async () => (await listOf(app))[1]).toMatch(/ at 71\.5 \| /);
  },
);

/** Opens a window of the editor, looks at it and closes it. */
async function lookAt(app: App, panel: string): Promise<readonly string[]> {
  await courseMenu(app, panel);
  await until(app, by(`panel-${panel}`));
  const found = await violationsOn(app);
  await app.click(`${by(`panel-${panel}`)} .title button`);
  await gone(app, by(`panel-${panel}`));
  return found;
}

for (const theme of ['light', 'dark'] as const)
  test(`axe finds nothing that shuts people out of the course editor, ${theme}`, IN_ONE_ENGINE, async ({ app }) => {
    await openApp(app, { theme, language: 'en' });
    await build(app);
    const pupil = withMouse(app);
    for (const tool of ['pen', 'block', 'zone', 'label', 'start']) {
      await pupil.chooseTool(tool);
      expect(await violationsOn(app), `with the options of ${tool}`).toEqual([]);
    }
    for (const at of [700, 710]) {
      await pupil.chooseTool('block');
      await pupil.draw([[at, 400]]);
    }
    await until(app, by('problems'));
    expect(await violationsOn(app), 'with a hint').toEqual([]);
    expect(await lookAt(app, 'list'), 'with the list').toEqual([]);
    expect(await lookAt(app, 'course'), 'with the settings').toEqual([]);
    await app.click(by('share'));
    await until(app, by('share-link'));
    expect(await isThere(app, by('share-qr'))).toBe(true);
    expect(await violationsOn(app), 'with the link').toEqual([]);
  });
