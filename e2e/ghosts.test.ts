import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { consoleIn, isThere, on, openApp, pasteProgram } from './page';
import { by, gone, until } from './parts';
import { dropFile, savedFiles, watchSaving } from './transfer';

/** Drives on and on for a while, at this speed; then says so. */
const drive = (speed: number): string => `from mbrobot import *
setSpeed(${speed})
forward()
delay(1500)
stop()
print("done")
`;
const ghost = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="ghost"]')?.textContent?.trim() ?? '');

/** How many runs that the console still tells of have come to their end. */
const ended = async (app: App): Promise<number> => (await consoleIn(app)).split('done').length - 1;

async function run(app: App, program: string): Promise<void> {
  await pasteProgram(app, program.trimEnd());
  const before = await ended(app);
  await app.click(on('run'));
  await expect.poll(() => ended(app)).toBe(before + 1);
}

async function choose(app: App, id: string): Promise<void> {
  await app.click(by('show'));
  await until(app, by(id));
  await app.click(by(id));
  await app.press('Escape');
  await gone(app, by(id));
}

test('the last run is raced against when it is chosen, and hidden again', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await run(app, drive(50));
  expect(await isThere(app, by('ghost'))).toBe(false);
  await run(app, drive(20));
  expect(await isThere(app, by('ghost'))).toBe(false); // nobody has asked for one
  await app.click(by('show'));
  await until(app, by('ghost-last'));
  expect(await isThere(app, by('ghost-best'))).toBe(true); // the course has a task
  expect(await isThere(app, by('ghost-opened'))).toBe(false);
  expect(await violationsOn(app)).toEqual([]);
  await app.press('Escape');
  await choose(app, 'ghost-last');
  await until(app, by('ghost'));
  expect(await ghost(app)).toMatch(/\b1 · 1[.,]\d s$/);
  await app.click(on('run'));
  await expect.poll(() => ghost(app)).toMatch(/\b2 · 1[.,]\d s$/);
  await app.click(by('ghost-away'));
  await gone(app, by('ghost'));
});

test('a run out of a file is raced against by the next one', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await run(app, drive(50));
  await app.click(by('mode-lookBack'));
  await watchSaving(app);
  await until(app, by('save-run'));
  await app.click(by('save-run'));
  await until(app, by('save-run-file'));
  await app.click(by('save-run-file'));
  await expect.poll(async () => (await savedFiles(app)).length).toBe(1);
  const [file] = await savedFiles(app);
  await app.goto('./logo.svg');
  await openApp(app);
  await dropFile(app, file!);
  await until(app, by('time-rail'));
  expect(await isThere(app, by('ghost'))).toBe(false);
  await until(app, by('save-run'));
  await run(app, drive(20));
  await until(app, by('ghost'));
  expect(await ghost(app)).toMatch(/ · 1[.,]\d s$/);
});
