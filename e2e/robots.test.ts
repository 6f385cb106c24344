import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { attribute, consoleIn, isThere, on, openApp, pasteProgram, programIn, robotIn, robotName } from './page';
import { by, choose, gone, until } from './parts';
import { openDeviceSettings } from './pupil';

const isAt = (app: App, css: string): Promise<boolean> =>
  app.evaluate((selector) => document.activeElement?.matches(selector) === true, css);

/** Goes on with Tab until the keyboard is at an element. */
async function tabTo(app: App, css: string): Promise<void> {
  for (let press = 0; press < 60 && !(await isAt(app, css)); press += 1) await app.press('Tab');
  expect(await isAt(app, css), css).toBe(true);
}

async function openDevice(app: App): Promise<void> {
  await app.click(by('device'));
  await until(app, by('robot-auto'));
}

const chosen = (app: App, option: string): Promise<string | null> =>
  app.evaluate((css) => document.querySelector<HTMLSelectElement>(css)?.value ?? null, by(`option-${option}`));

test(
  'the gallery opens by keyboard, a page tells of its robot, Escape leads back to where the keyboard was',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), by('device'));
    await app.press('Enter');
    await until(app, by('device-all'));
    await tabTo(app, by('device-all'));
    await app.press('Enter');
    await until(app, by('gallery'));
    await tabTo(app, by('gallery'));
    await app.press('Enter');
    await until(app, by('card-callibot'));
    await expect.poll(() => app.text('.gallery h2')).toBe('Robot gallery'); // it fades in
    await tabTo(app, `${by('card-callibot')} a`);
    await app.press('Enter');
    await until(app, '.gallery .sheet');
    await expect.poll(() => isAt(app, '.gallery h2')).toBe(true); // a screen reader begins with the robot's name
    expect(await app.text('.gallery h2')).toBe('Calli:bot');
    const sheet = await app.text('.gallery .sheet');
    for (const word of ['Calliope mini 3', '0x20', '0x22', 'Wiring', 'Libraries', 'setSpeed(', 'Attachments', '0°'])
      expect(sheet).toContain(word);
    await app.press('Escape');
    await gone(app, '.gallery');
    expect(await isAt(app, by('device'))).toBe(true);
    expect(await app.evaluate(() => location.hash)).toBe('');
  },
);

test(
  'a link leads to a robot’s page; its example opens with the robot and its board, and drives; nothing is lost',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en', robot: 'maqueen-lite', device: 'microbit-v2' });
    await pasteProgram(app, 'print("mine")');
    await app.goto('./#robots/callibot');
    await until(app, by('open-first_drive.py'));
    await app.click(by('open-first_drive.py'));
    await gone(app, '.gallery');
    await expect.poll(() => programIn(app)).toContain('from callibot import');
    expect(await programIn(app)).toContain('# First drive'); // in the language of the page
    await expect.poll(() => robotName(app)).toBe('Calli:bot');
    await expect.poll(() => attribute(app, by('device'), 'aria-label')).toContain('Calliope mini 3');
    expect(await isThere(app, by('misplugged'))).toBe(false);
    await expect.poll(() => app.text('.notice')).toContain('Your work has been kept');

    const start = (await robotIn(app)).xMm;
    await app.click(on('run'));
    await expect.poll(async () => (await robotIn(app)).xMm, { timeout: 30_000 }).not.toBe(start);
    await app.click(on('reset'));
    await app.click('header .course');
    await until(app, by('previous'));
    await app.click(by('previous'));
    await expect.poll(() => programIn(app)).toBe('print("mine")');
  },
);

test(
  'a robot and its attachment are chosen by hand; a change ends the run and says so; a reload keeps both',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await openDeviceSettings(app);
    await app.click(by('robot-maqueen-plus-v2'));
    await until(app, by('option-P1'));
    await expect.poll(() => robotName(app)).toBe('Maqueen Plus V2');
    await app.press('Escape');
    await gone(app, by('option-P1'));

    await pasteProgram(app, 'from mbrobot_plusV2 import *\nforward()\nprint("drives")\nwhile True:\n    delay(100)');
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('drives');
    await openDeviceSettings(app);
    await choose(app, 'P1', 'claw');
    await expect.poll(() => app.text('.notice')).toBe('Stopped, because you changed something about the robot.');
    await expect.poll(() => app.text('.pane-console .pane-head')).toContain('ready');

    await app.reload();
    await until(app, by('device'));
    await openDeviceSettings(app);
    expect(await chosen(app, 'P1')).toBe('claw');
    await app.click(by('options-reset'));
    expect(await chosen(app, 'P1')).toBe('none');
    await gone(app, by('options-reset'));
  },
);

test(
  'on the wrong board the robot hears nothing: one sentence says what is plugged where, a button mends it',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en', robot: 'callibot', device: 'microbit-v2' });
    await pasteProgram(app, 'from microbit import *\ni2c.init()\ni2c.write(0x20, bytes([0, 0, 100]))');
    await until(app, `.pane-arena ${by('misplugged')}`);
    expect(await app.text(`.pane-arena ${by('misplugged')} p`)).toBe(
      'The Calli:bot belongs on a Calliope mini 3. A micro:bit V2 is plugged in here: the robot hears nothing.',
    );
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('[Errno 19] ENODEV');
    await app.click(`.pane-arena ${by('plug-in')}`);
    await gone(app, by('misplugged'));
    await expect.poll(() => attribute(app, by('device'), 'aria-label')).toContain('Calliope mini 3');
    await expect.poll(() => robotName(app)).toBe('Calli:bot');

    // Where the arena is out of sight, the console says it.
    await app.evaluate(
      (text) => localStorage.setItem('parcours.settings', text),
      JSON.stringify({ language: 'en', robot: 'callibot', device: 'microbit-v2', showArena: false }),
    );
    await app.evaluate(() => sessionStorage.removeItem('parcours.settings'));
    await app.reload();
    await until(app, on('editor'));
    await app.click(on('run'));
    await expect.poll(() => app.text('.pane-console')).toContain('The Calli:bot belongs on a Calliope mini 3.');
  },
);

test(
  'the reality slider: forward() goes straight with an ideal robot and drifts with a used one',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const DRIVE = 'from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(1500)\nstop()\ndelay(300)\nprint("there")';
    const drift = async (): Promise<number> => {
      await app.click(on('run'));
      await expect.poll(() => consoleIn(app), { timeout: 40_000 }).toMatch(/there\s/);
      const headingDeg = await headingAtRest(app);
      await app.click(on('reset'));
      await app.click(by('console-fold'));
      await app.click('.pane-console [aria-label="Clear console"]');
      await expect.poll(async () => (await robotIn(app)).xMm).toBeLessThan(550); // the text follows a second later
      return headingDeg > 180 ? headingDeg - 360 : headingDeg;
    };
    await openApp(app, { language: 'en', speed: 'max' });
    await pasteProgram(app, DRIVE);
    expect(Math.abs(await drift())).toBeLessThan(1);
    await openDevice(app);
    await until(app, `${by('reality')} input`);
    await app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), `${by('reality')} input`);
    await app.press('End');
    await expect.poll(() => app.text(by('reality'))).toContain('like an old school robot');
    await app.press('Escape');
    await gone(app, by('reality'));
    const used = await drift();
    expect(Math.abs(used)).toBeGreaterThan(3);
    expect(await drift(), 'the same robot once more').toBe(used);

    await openDevice(app);
    await until(app, by('seed'));
    expect(await numberOf(app)).toBe('1');
    await app.click(`${by('seed')} button`);
    await expect.poll(() => numberOf(app)).toBe('2');
    await expect.poll(() => app.text(by('seed'))).toContain('the same number always gives the same one');
    await app.press('Escape');
    await gone(app, by('reality'));
    const other = await drift();
    expect(Math.abs(other - used), 'another robot').toBeGreaterThan(0.1);

    await app.reload();
    await until(app, by('device'));
    await openDevice(app);
    await until(app, by('seed'));
    expect(await numberOf(app)).toBe('2');
    await app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), `${by('reality')} input`);
    await app.press('Home');
    await gone(app, by('seed')); // the ideal robot has no number
  },
);

/** The robot's heading at rest. The picture follows the program's output, some of it ten times a second. */
async function headingAtRest(app: App): Promise<number> {
  let before = await robotIn(app); // it starts at 400 mm
  const isAtRest = async (): Promise<boolean> => {
    const now = await robotIn(app);
    const isSame = now.xMm === before.xMm && now.headingDeg === before.headingDeg;
    before = now;
    return isSame && now.xMm > 550;
  };
  await expect.poll(isAtRest, { intervals: [600] }).toBe(true);
  return before.headingDeg;
}

const numberOf = (app: App): Promise<string | null> =>
  app.evaluate((css) => document.querySelector<HTMLInputElement>(css)?.value ?? null, `${by('seed')} input`);

for (const theme of ['light', 'dark'] as const) {
  test(
    `axe finds nothing that shuts people out of the gallery and the device panel, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { theme, language: 'en', robot: 'maqueen-lite', device: 'calliope-mini-3', reality: 0.5 });
      await openDevice(app);
      await until(app, `.device-panel ${by('misplugged')}`);
      expect(await violationsOn(app), 'the menu of the device').toEqual([]);
      await app.click(by('device-all'));
      await until(app, `.device-card ${by('misplugged')}`);
      await until(app, by('seed'));
      expect(await violationsOn(app), 'the device panel').toEqual([]);
      await app.click(by('gallery'));
      await until(app, by('card-maqueen-lite'));
      await expect.poll(() => isAt(app, '.gallery h2')).toBe(true); // it has faded in
      expect(await violationsOn(app), 'all robots').toEqual([]);
      await app.click(by('more-maqueen-lite'));
      await until(app, '.gallery .sheet');
      await app.evaluate(() => document.querySelectorAll('details').forEach((fold) => fold.setAttribute('open', '')));
      expect(await violationsOn(app), 'a robot').toEqual([]);
    },
  );
}
