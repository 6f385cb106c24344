import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { openApp, pasteProgram, programIn, typeProgram } from './page';
import { by, gone, until } from './parts';

test('a reload keeps the program', async ({ app }) => {
  const source = 'print("kept")\nx = 1';
  await openApp(app);
  await typeProgram(app, source);
  await app.reload();
  await expect.poll(() => programIn(app)).toBe(source);
});

test('each mission opens with what was written in it', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  const mission = async (name: string): Promise<void> => {
    await app.evaluate(() => void (location.hash = 'missions'));
    await until(app, by(`mission-${name}`));
    await app.click(`${by(`mission-${name}`)} button`);
    await gone(app, by(`mission-${name}`));
    await app.click(by('task-close'));
    await until(app, by('task-open'));
  };
  await mission('corner');
  await pasteProgram(app, 'corner = 1\n');
  await mission('square');
  await pasteProgram(app, 'square = 1\n');
  await mission('corner');
  await expect.poll(() => programIn(app)).toBe('corner = 1\n');
  await mission('square');
  await expect.poll(() => programIn(app)).toBe('square = 1\n');
  await app.reload();
  await expect.poll(() => programIn(app)).toBe('square = 1\n');
});
