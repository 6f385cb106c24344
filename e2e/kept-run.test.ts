import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { attribute, consoleIn, on, openApp, pasteProgram, programIn, robotIn } from './page';
import { by, gone, until } from './parts';
import { dropFile, savedFiles, watchSaving } from './transfer';

const PROGRAM = `from mbrobot import *
from microbit import button_a
setSpeed(40)
forward()
for n in range(20):
    if button_a.is_pressed(): left()
    print("number", n)
    delay(100)
stop()
`;
const folder = mkdtempSync(join(tmpdir(), 'parcours-run-'));
test.afterAll(() => rmSync(folder, { recursive: true }));

/** The path of a new file. */
function file(name: string, text: string): string {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}
/** The command line's output and exit code. */
function parcours(...args: readonly string[]): {
  readonly code: number | null;
  readonly said: string;
  readonly out: string;
} {
  const { status, stderr, stdout } = spawnSync(process.execPath, ['bin/parcours.mjs', ...args], { encoding: 'utf8' });
  return { code: status, said: stderr, out: stdout };
}
interface Kept {
  readonly untilUs: number;
  readonly result: { readonly traceHash: string; readonly simulatedUs: number };
}
const read = (text: string): Kept => JSON.parse(text) as Kept;
const noticeIn = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('.notice p')?.textContent ?? '');
/** Simulated time on the time line, in ms. */
const at = async (app: App): Promise<number> => Number(await attribute(app, by('time-rail'), 'aria-valuenow'));

/** Saves the run that is looked back at. */
async function saved(app: App): Promise<{ readonly name: string; readonly text: string }> {
  await watchSaving(app);
  await until(app, by('save-run'));
  await app.click(by('save-run'));
  await until(app, by('save-run-file'));
  await app.click(by('save-run-file'));
  await expect.poll(async () => (await savedFiles(app)).length).toBe(1);
  return (await savedFiles(app))[0]!;
}

test(
  'a run recorded on the command line is seen on the page from its beginning, and goes back the same',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const path = join(folder, 'recorded.json');
    const inputs = file(
      'inputs.json',
      '[{ "at": "500ms", "button": "a", "down": true }, { "at": "900ms", "button": "a", "down": false }]',
    );
    expect(parcours('run', file('main.py', PROGRAM), '--input', inputs, '--record', path, '--quiet').code).toBe(0);
    const text = readFileSync(path, 'utf8');
    await openApp(app);
    await dropFile(app, { name: 'recorded.json', text });
    await until(app, by('time-rail'));
    expect(await at(app)).toBe(0);
    await expect.poll(() => programIn(app)).toBe(PROGRAM);
    await expect.poll(() => noticeIn(app)).toContain('recorded.json');
    const start = await robotIn(app);
    await until(app, by('save-run'));
    expect(await violationsOn(app)).toEqual([]);
    await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
    await app.press('End');
    await expect.poll(async () => Math.abs((await robotIn(app)).headingDeg - start.headingDeg)).toBeGreaterThan(5);
    expect(await consoleIn(app)).toContain('number 19');
    const again = await saved(app);
    expect(read(again.text).result.traceHash).toBe(read(text).result.traceHash);
    const { code, said } = parcours('replay', file('again.json', again.text), '--quiet');
    expect([code, said]).toEqual([0, expect.stringContaining(read(text).result.traceHash.slice(0, 16))]);
  },
);

test('a run of the page is saved, is the same on the command line, and opens again', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM.trimEnd());
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('number 9');
  await app.click(by('mode-lookBack'));
  const { name, text } = await saved(app);
  expect(name).toMatch(/\.run\.json$/);
  const { code, said } = parcours('replay', file('page.json', text), '--quiet');
  expect([code, said]).toEqual([0, expect.stringContaining(`hash ${read(text).result.traceHash.slice(0, 16)}`)]);
  await app.click(by('mode-drive'));
  await gone(app, by('time-rail'));
  await dropFile(app, { name, text });
  await until(app, by('time-rail'));
  expect(await at(app)).toBe(0);
  await expect.poll(() => noticeIn(app)).toContain(name);
  // A program that was changed since is opened, and its run is not shown.
  await dropFile(app, { name: 'changed.run.json', text: text.replace('range(20)', 'range(3)') });
  await expect.poll(() => programIn(app)).toContain('range(3)');
  await expect.poll(() => noticeIn(app)).toContain('changed.run.json');
  await gone(app, by('time-rail'));
});

test('a run is passed on as a link, from its start or to the same moment', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM.trimEnd());
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('number 15');
  await app.click(by('mode-lookBack'));
  await until(app, by('time-rail'));
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
  await app.press('Home');
  await app.strike(Array.from({ length: 49 }, () => 'ArrowRight'));
  await expect.poll(() => at(app)).toBe(980);
  const { text } = await saved(app);
  const { out } = parcours('replay', file('link.json', text), '--at', '0.98s', '--json');
  const { robot } = JSON.parse(out) as { readonly robot: { readonly xMm: number } };
  await app.click(by('save-run'));
  await until(app, by('save-run-link'));
  await app.click(by('save-run-link'));
  await until(app, by('run-link'));
  expect(await violationsOn(app)).toEqual([]);
  const linkIn = (): Promise<string> =>
    app.evaluate(() => document.querySelector<HTMLInputElement>('[data-testid="run-link"]')?.value ?? '');
  expect(await linkIn()).toMatch(/#r=1\.0\.[\w-]+$/);
  await app.click(by('save-run-from-there'));
  const link = await linkIn();
  expect(link).toMatch(/#r=1\.980\.[\w-]+$/);
  await app.goto('./logo.svg'); // the page itself would only hear of another fragment
  await app.goto(`./${link.slice(link.indexOf('#'))}`);
  await until(app, by('time-rail'));
  await expect.poll(() => at(app)).toBe(980);
  expect(await programIn(app)).toBe(PROGRAM.trimEnd());
  await expect.poll(async () => Math.abs((await robotIn(app)).xMm - robot.xMm)).toBeLessThanOrEqual(5); // whole cm
});
