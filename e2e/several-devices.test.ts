import { expect, test, type App } from './app';
import { inWindow } from './arena';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { isAt, tabTo } from './keys';
import { enterMode, on, openApp, pasteProgram, programIn, robotIn } from './page';
import { by, gone, until } from './parts';
import { openEditor, toolButton } from './pupil';
import { tablet, withFingers } from './touch';

const ROBOT = `from mbrobot import *
import radio
radio.on()
while True:
    order = radio.receive()
    if order == "go":
        forward()
        print("driving")
    elif order == "stop":
        stop()
    delay(20)
`;
const REMOTE = `from microbit import *
import radio
radio.on()
while True:
    if button_a.was_pressed():
        radio.send("go")
    if button_b.was_pressed():
        radio.send("stop")
    sleep(50)
`;
const card = (place: number, part: string): string => `.device-row .card:nth-child(${String(place + 1)}) ${part}`;
const lines = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="console"]')?.textContent ?? '');

/** From the page with a robot's program to a pair: a remote control is added, and its program written. */
async function addRemote(app: App, press: (css: string) => Promise<void>): Promise<void> {
  await openApp(app);
  await pasteProgram(app, ROBOT);
  await press(by('device'));
  await until(app, by('add-device'));
  await press(by('add-device'));
  await until(app, by('add-device-board'));
  await press(by('add-device-board'));
  await until(app, by('device-card'));
  await expect.poll(() => programIn(app)).toContain('radio.on()');
  await pasteProgram(app, REMOTE);
}

async function driveByRemote(app: App, press: (css: string) => Promise<void>): Promise<void> {
  const start = await robotIn(app);
  await press(on('run'));
  await until(app, card(0, '.tone--run'));
  await press(card(1, '.round'));
  await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(start.xMm + 20);
  await expect.poll(() => lines(app)).toContain('driving');
  await press(card(1, '.round:last-child'));
  await expect
    .poll(async () => {
      const before = await robotIn(app);
      await new Promise((resolve) => setTimeout(resolve, 300));
      return (await robotIn(app)).xMm - before.xMm;
    })
    .toBe(0);
}

test(
  'a remote control is added, written and drives the robot; the pair is there after a reload',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await addRemote(app, (css) => app.click(css));
    await app.click(card(0, '.select'));
    await expect.poll(() => programIn(app)).toBe(ROBOT);
    await driveByRemote(app, (css) => app.click(css));
    await app.reload();
    await until(app, by('device-card'));
    await expect.poll(() => programIn(app)).toBe(ROBOT);
    await app.click(card(1, '.select'));
    await expect.poll(() => programIn(app)).toBe(REMOTE);
  },
);

test(
  'by keyboard a device is chosen and taken away, and nothing bars a screen reader',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await addRemote(app, (css) => app.click(css));
    expect(await violationsOn(app)).toEqual([]);
    await app.click(`${by('held-board')} button`); // the remote control is seen in the arena, and chosen there
    await until(app, `${card(1, '.select')}[aria-pressed="true"]`);
    await tabTo(app, card(0, '.select'));
    await app.press('Enter');
    await expect.poll(() => programIn(app)).toBe(ROBOT);
    await app.press('Tab');
    expect(await isAt(app, card(0, '.round'))).toBe(true);
    await tabTo(app, card(1, '.select'));
    await app.press('Enter');
    await app.click(by('device'));
    await until(app, by('device-remove'));
    await app.click(by('device-remove'));
    await gone(app, by('device-card'));
    await expect.poll(() => programIn(app)).toBe(ROBOT);
  },
);

test(
  'the course places a second robot: its start is added by a button, and the robot drives from there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await openEditor(app);
    await app.click(toolButton('start'));
    await expect.poll(async () => (await robotIn(app)).xMm).toBe(FIRST[0]);
    await app.click(by('add-start'));
    await enterMode(app, 'drive');
    await app.click(by('device'));
    await until(app, by('add-device'));
    await app.click(by('add-device'));
    await until(app, by('add-device-robot'));
    await app.click(by('add-device-robot'));
    await until(app, by('device-card'));
    const start = await startIn(app);
    await expect.poll(() => robotIn(app)).toMatchObject({ xMm: start[0], yMm: start[1] });
    await pasteProgram(app, 'from mbrobot import *\nforward()\n');
    await app.click(on('run'));
    await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(start[0] + 20);
    await app.click(on('stop'));
    await app.click(by('reset')); // both are where they start again
    await app.draw(await inWindow(app, [1200, 900], [FIRST])); // the hand takes the robot of the device that is shown
    await until(app, `${card(0, '.select')}[aria-pressed="true"]`);
  },
);

/** The robot's start on the closed line, in mm. */
const FIRST = [400, 130] as const;

/** The start of the second robot in the saved course. */
async function startIn(app: App): Promise<readonly [number, number]> {
  const find = (): Promise<readonly [number, number] | null> =>
    app.evaluate(() => {
      const text = sessionStorage.getItem('parcours.work') ?? '{}';
      const { project } = JSON.parse(text) as {
        project?: { scene: { objects?: { type: string; at: [number, number] }[] } };
      };
      return project?.scene.objects?.find(({ type }) => type === 'start')?.at ?? null;
    }, null);
  await expect.poll(find).not.toBeNull();
  return (await find()) ?? [NaN, NaN];
}

test.describe('with fingers on a tablet', () => {
  test.use(tablet);
  test('a pair comes from the empty page to a working remote control', IN_ONE_ENGINE, async ({ page }) => {
    const { app } = await withFingers(page);
    await addRemote(app, (css) => app.click(css));
    await app.click(card(0, '.select'));
    await driveByRemote(app, (css) => app.click(css));
  });
});
