import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { isThere, keepDown, on, openApp, pasteProgram, robotIn, type Shown } from './page';
import { by, gone, until } from './parts';
import { clearAll, listOf, openEditor, withMouse } from './pupil';

const PROGRAM = `from mbrobot import *
setSpeed(30)
forward()
for n in range(1000):
    print("number", n)
    delay(100)
`;
const output = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="console"]')?.textContent ?? '');
/** Simulated time on the time line, in ms. */
const at = async (app: App): Promise<number> =>
  Number(await app.evaluate(() => document.querySelector('[data-testid="time-rail"]')?.getAttribute('aria-valuenow')));

/** The robot's place once the words about it, renewed once a second, no longer change. */
async function robotAtRest(app: App): Promise<Shown> {
  let last = await robotIn(app);
  await expect
    .poll(
      async () => {
        const before = last;
        last = await robotIn(app);
        return last.xMm === before.xMm;
      },
      { intervals: [1200] },
    )
    .toBe(true);
  return last;
}

test('a run is looked back at by keys, and goes on from an earlier moment', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM);
  const start = await robotIn(app);
  await app.click(on('run'));
  await expect.poll(() => output(app)).toContain('number 30'); // the words about the robot may be a second late
  await app.click(by('mode-lookBack'));
  await until(app, by('time-rail'));
  const far = await robotAtRest(app);
  expect(await violationsOn(app)).toEqual([]);
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
  await app.press('Home');
  await expect.poll(() => at(app)).toBe(0);
  await expect.poll(async () => (await robotIn(app)).xMm).toBeCloseTo(start.xMm, 0);
  await app.press('PageUp');
  await app.press('ArrowLeft');
  await expect.poll(() => at(app)).toBe(980);
  await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(start.xMm + 10);
  await expect.poll(async () => (await robotIn(app)).xMm).toBeLessThan(far.xMm);
  const there = await robotIn(app);
  await app.click(by('go-on'));
  await gone(app, by('time-rail'));
  // It has forgotten what came later and drives on from there; on a slow machine it had come to the wall before.
  await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(there.xMm + 20);
});

test('what was left drives along as a ghost as soon as something goes another way', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await pasteProgram(
    app,
    'from mbrobot import *\nfrom microbit import button_a\nsetSpeed(30)\nforward()\nwhile not button_a.was_pressed(): delay(20)\nstop()\nprint("stopped")\n',
  );
  await app.click(on('run'));
  await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(400);
  await app.click(by('mode-lookBack'));
  await until(app, by('time-rail'));
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
  await app.press('Home');
  await app.click(by('go-on'));
  await gone(app, by('time-rail'));
  await keepDown(app, { down: () => app.hold('a'), up: () => app.release('a') }, 'stopped'); // another way
  await until(app, by('ghost'));
  await expect.poll(() => output(app)).toContain('stopped');
  await app.click(by('ghost-away'));
  await gone(app, by('ghost'));
});

test(
  'nobody draws in the past: a tool that was chosen rests, the run stays, and the tool comes back',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const pupil = withMouse(app);
    await openEditor(app);
    await clearAll(app);
    await pupil.chooseTool('block');
    await pupil.draw([[350, 700]]);
    const before = await listOf(app);
    await app.click(on('run'));
    await app.click(by('mode-lookBack'));
    await until(app, by('time-rail'));
    await pupil.draw([[700, 200]]);
    await pupil.draw([[200, 200], [500, 200]]); // prettier-ignore
    await app.press('Delete');
    await until(app, by('time-rail'));
    await app.click(by('mode-drive'));
    await gone(app, by('time-rail'));
    expect(await isThere(app, '[data-tool]')).toBe(false);
    expect(await listOf(app)).toEqual(before);
    await until(app, '[data-tool="block"][aria-pressed="true"]');
  },
);
