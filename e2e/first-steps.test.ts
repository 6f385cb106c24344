import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { isAt, tabTo } from './keys';
import { attribute, consoleIn, isEnabled, isThere, on, openApp, pasteProgram, programIn } from './page';
import { by, gone, until as there } from './parts';
import { beginWith, mainMenu } from './pupil';

const stepIs = (app: App, step: string): Promise<void> =>
  expect.poll(() => attribute(app, by('tour'), 'data-step')).toBe(step);
/** Chromium and Firefox get the keyboard into a menu by themselves. */
async function fromMenu(app: App, entry: string): Promise<void> {
  await tabTo(app, by('menu'));
  await app.press('Enter');
  await there(app, by(entry));
  await expect(async () => {
    await app.press('ArrowDown');
    expect(await isAt(app, by(entry))).toBe(true);
  }).toPass();
  await app.press('Enter');
}
async function pressAt(app: App, css: string): Promise<void> {
  await tabTo(app, css);
  await app.press('Enter');
}

test('the tour makes the greeting go, waits for real presses, and is gone on with after a reload', async ({ app }) => {
  await openApp(app);
  await there(app, by('welcome'));
  expect(await isAt(app, by('welcome')), 'the greeting does not take the keyboard').toBe(false);
  await fromMenu(app, 'menu-tour');
  await gone(app, by('welcome'));
  await stepIs(app, 'code');
  await expect.poll(() => isAt(app, by('tour'))).toBe(true);
  await pressAt(app, by('tour-next'));
  await stepIs(app, 'run');

  await pressAt(app, by('tour-there'));
  expect(await isAt(app, on('run'))).toBe(true);
  await app.press('Enter');
  await stepIs(app, 'arena');
  await expect.poll(() => isAt(app, by('tour'))).toBe(true);
  expect(await isThere(app, by('tour-ring'))).toBe(true);

  await app.press('Escape');
  await gone(app, by('tour'));
  await app.reload();
  await there(app, on('editor'));
  await gone(app, by('welcome'));
  await fromMenu(app, 'menu-tour');
  await stepIs(app, 'arena');
  await app.press('Escape');
  await expect.poll(() => isAt(app, by('menu')), 'the keyboard is where it was before').toBe(true);
});

test('the tour leads on to the first mission by keyboard, and is over then', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'en', tourStep: 'arena' });
  await fromMenu(app, 'menu-tour');
  await stepIs(app, 'arena');
  for (const step of ['console', 'stop', 'tools', 'course', 'help']) {
    await pressAt(app, by('tour-next'));
    await stepIs(app, step);
    await expect.poll(() => isAt(app, by('tour'))).toBe(true);
  }
  await pressAt(app, by('tour-next'));
  await gone(app, by('tour'));
  await expect.poll(() => isAt(app, by('task-card')), 'the keyboard is at the mission').toBe(true);
});

test('the help finds buttons and writes a command into the program', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'de' });
  await there(app, by('menu'));
  await expect(async () => {
    if (!(await isThere(app, by('guide')))) await app.press('F1');
    await expect.poll(() => isAt(app, by('guide-search')), { timeout: 3000 }).toBe(true);
  }).toPass();
  await app.type('ZURUCK start');
  await there(app, '#guide-reset');
  await app.press('Control', 'a');
  await app.type('zeitlupe');
  await there(app, '#guide-speed');
  await gone(app, '#guide-save-scene');

  await app.press('Escape'); // empties the search
  await expect.poll(() => isThere(app, '[data-section=steps]')).toBe(true);
  await app.press('Escape'); // closes the help
  await gone(app, by('guide'));
  await pasteProgram(app, 'from mbrobot import *\nforward()');
  await app.press('Control', 'End');
  await mainMenu(app, 'help');
  await expect.poll(() => isAt(app, by('guide-search'))).toBe(true);
  await app.type('leftarc');
  const command = '[data-command="mbrobot.leftArc"]';
  await there(app, command);
  await pressAt(app, command);
  await expect.poll(() => programIn(app)).toBe('from mbrobot import *\nforward()\nleftArc(radius)');
  await expect.poll(() => app.text(by('guide-found'))).toContain('leftArc(radius)');
});

test(
  'the microcomputer alone, the robot, the tools: each brings a program that fits',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await beginWith(app, 'board');
    await gone(app, on('arena'));
    await expect.poll(() => programIn(app)).toContain('from microbit import *');
    await app.click(on('run'));
    await expect.poll(() => isEnabled(app, 'stop')).toBe(true);

    await beginWith(app, 'robot');
    await there(app, on('arena'));
    await gone(app, by('palette'));
    await expect.poll(() => programIn(app)).toContain('from mbrobot import *');
    await beginWith(app, 'all');
    await there(app, by('palette'));
  },
);

test('whatever is in sight, a pupil’s own program stays', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'en' });
  await pasteProgram(app, 'print("mine")');
  await beginWith(app, 'board');
  await gone(app, on('arena'));
  expect(await programIn(app)).toBe('print("mine")');
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('mine');
  await beginWith(app, 'all');
  await there(app, by('palette'));
  expect(await programIn(app)).toBe('print("mine")');
});

test('the greeting is there on a first visit only, and goes with the first run', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await there(app, by('welcome'));
  await app.click(on('run'));
  await gone(app, by('welcome'));
  await app.reload();
  await there(app, by('menu'));
  await mainMenu(app, 'help'); // the help comes by the same way as the greeting
  await there(app, by('guide-search'));
  expect(await isThere(app, by('welcome'))).toBe(false);
});

for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing that shuts people out of the help, ${theme}`, IN_ONE_ENGINE, async ({ app }) => {
    await openApp(app, { theme, language: 'fr' });
    await mainMenu(app, 'help');
    await there(app, by('guide-search'));
    await app.evaluate(() => {
      const folds = document.querySelectorAll<HTMLElement>('[data-testid=guide] [aria-expanded=false]');
      folds.forEach((fold) => fold.click());
    });
    await there(app, '[data-command]');
    expect(await violationsOn(app), 'with all of the help').toEqual([]);
  });
}
