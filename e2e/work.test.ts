import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { openApp, pasteProgram, programIn, typeProgram } from './page';
import { by, gone, until } from './parts';

/** Opens a mission out of the ladder, and folds its card. */
async function openMission(app: App, name: string): Promise<void> {
  await app.evaluate(() => void (location.hash = 'missions'));
  await until(app, by(`mission-${name}`));
  await app.click(`${by(`mission-${name}`)} button`);
  await gone(app, by(`mission-${name}`));
  await app.click(by('task-close'));
  await until(app, by('task-open'));
}

test('a reload keeps the program', async ({ app }) => {
  const source = 'print("kept")\nx = 1';
  await openApp(app);
  await typeProgram(app, source);
  await app.reload();
  await expect.poll(() => programIn(app)).toBe(source);
});

test('each mission opens with what was written in it', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await openMission(app, 'corner');
  await pasteProgram(app, 'corner = 1\n');
  await openMission(app, 'square');
  await pasteProgram(app, 'square = 1\n');
  await openMission(app, 'corner');
  await expect.poll(() => programIn(app)).toBe('corner = 1\n');
  await openMission(app, 'square');
  await expect.poll(() => programIn(app)).toBe('square = 1\n');
  await app.reload();
  await expect.poll(() => programIn(app)).toBe('square = 1\n');
});

test(
  'my work is a page: what was written in a mission is found by its text, and opened again',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await openMission(app, 'forward');
    await pasteProgram(app, 'first = 1\n');
    await app.click('header .course');
    await until(app, by('missions'));
    await app.click(by('missions'));
    await until(app, by('mission-corner'));
    await app.click(`${by('mission-corner')} button`);
    await gone(app, by('mission-corner'));
    await app.click(by('task-close'));
    await pasteProgram(app, 'corner = 2\n');

    await app.click('header .course');
    await until(app, by('my-works'));
    await app.click(by('my-works'));
    await until(app, by('works-search'));
    await app.fill(by('works-search'), 'first = 1');
    await gone(app, by('work-corner-maqueen-lite'));
    await app.click(`${by('work-forward-maqueen-lite')} button`);
    await expect.poll(() => app.text(by('work-program'))).toContain('first = 1');
    expect(await app.evaluate(() => location.hash)).toBe('#works/forward-maqueen-lite');
    expect(await violationsOn(app)).toEqual([]);
    await app.click(by('work-open'));
    await gone(app, by('works-search'));
    await expect.poll(() => programIn(app)).toBe('first = 1\n');
  },
);
