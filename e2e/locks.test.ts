import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { openedCourse } from './opened-course';
import { attribute, isThere, on, openApp, programIn, robotIn } from './page';
import { by, until } from './parts';

const PROGRAM = 'from mbrobot import *\n\ndef turn():\n    right()\n    delay(500)\n\n# your part\n';
const LOCKS = { tools: ['wall'], course: true, hand: true, speed: 4, robot: true, solution: true, lines: [3, 4, 5] };

/** The closed line as a task that the class has got, with everything locked. */
async function openTask(app: App): Promise<void> {
  const work = JSON.parse(openedCourse('closed-line')) as { readonly project: object };
  const files = [{ name: 'main.py', text: PROGRAM }];
  const task = { version: 1, handedOut: true, checks: [{ type: 'goals', id: 'goals' }], locks: LOCKS };
  const kept = JSON.stringify({ ...work, project: { ...work.project, files, task } });
  await app.goto('./logo.svg'); // its storage is the app's, and it loads in no time
  await app.evaluate((text) => sessionStorage.setItem('parcours.work', text), kept);
  await openApp(app);
  await until(app, '.cm-lockedLine');
}

/** The message that is shown. */
const said = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('.notice p')?.textContent?.trim() ?? '');

/** Puts the cursor behind a line of the program. */
async function behindLine(app: App, line: number): Promise<void> {
  await app.click(`${on('editor')} .cm-line:nth-of-type(${String(line)})`);
  await app.press('End');
}

test(
  'a locked task: course, hand, speed, robot and lines stay as they are, and what is written around them goes',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openTask(app);
    await test.step('modes', async () => expect(await isThere(app, by('mode-build'))).toBe(false));
    await test.step('hand', async () => {
      const before = await robotIn(app);
      await app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), on('arena'));
      await app.press('ArrowUp');
      await expect.poll(() => said(app)).toMatch(/hand|Hand/);
      expect(await robotIn(app)).toEqual(before);
    });
    await test.step('speed and robot', async () => {
      await app.click(by('speed'));
      await expect.poll(() => app.evaluate(() => document.querySelectorAll('[role=menuitemradio][aria-disabled=true]').length)).toBe(6); // prettier-ignore
      await app.press('Escape');
      await app.click(by('device'));
      await until(app, by('device-kept'));
      expect(await app.evaluate(() => document.querySelector('.robots input')?.matches(':disabled'))).toBe(true);
      await app.press('Escape');
    });
    await test.step('lines', async () => {
      await behindLine(app, 4);
      await app.type('x');
      await app.press('Delete');
      await expect.poll(() => said(app)).toMatch(/lines|Zeilen/);
      expect(await programIn(app)).toBe(PROGRAM);
      await app.press('Control', 'a');
      await app.press('Delete');
      expect(await programIn(app)).toBe(PROGRAM);
      await behindLine(app, 7);
      await app.type(' is here');
      await app.press('Control', 'z');
      await app.press('Control', 'z');
      expect(await programIn(app)).toBe(PROGRAM);
      await behindLine(app, 1);
      await app.press('Enter');
      expect(await programIn(app)).toBe(PROGRAM.replace('*\n', '*\n\n'));
      expect(await attribute(app, '.cm-line:nth-of-type(6)', 'class')).toContain('cm-lockedLine');
    });
    expect(await violationsOn(app)).toEqual([]);
    await app.goto('./logo.svg');
    await app.goto('./?speed=8');
    await until(app, '.cm-lockedLine');
    expect(await app.evaluate(() => document.querySelector('[data-testid=speed] b')?.textContent)).toBe('4×');
    expect(await attribute(app, '.cm-line:nth-of-type(3)', 'class')).not.toContain('cm-lockedLine');
    expect(await isThere(app, '.cm-line:nth-of-type(6).cm-lockedLine')).toBe(true);
  },
);
