import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { isAt, tabTo } from './keys';
import { consoleIn, isEnabled, isThere, keepDown, on, openApp, pasteProgram, programIn } from './page';
import { by } from './parts';
import { fromMenu } from './pupil';

/** Tells every key that goes down or up, the shaking, the tilt and the light. */
const program = (module: string, pins: readonly string[]): string =>
  [
    `from ${module} import *`,
    'parts = [("A", button_a.is_pressed), ("B", button_b.is_pressed), ("logo", pin_logo.is_touched)]',
    ...pins.map((pin) => `parts.append(("${pin}", ${pin}.is_touched))`),
    'was = set()',
    'light = tilt = None',
    'print("ready")',
    'while True:',
    '    now = {name for name, is_down in parts if is_down()}',
    '    for name in now - was: print(name, "down")',
    '    for name in was - now: print(name, "up")',
    '    was = now',
    '    if accelerometer.was_gesture("shake"): print("shaken")',
    '    if accelerometer.get_x() != tilt:',
    '        tilt = accelerometer.get_x()',
    '        print("tilt", tilt)',
    '    if display.read_light_level() != light:',
    '        light = display.read_light_level()',
    '        print("light", light)',
    '    sleep(20)',
  ].join('\n');

const says = (app: App, text: string): Promise<void> => expect.poll(() => consoleIn(app)).toContain(text);

/** Holds a key of the board and lets go of it; the program sees both. */
async function hold(app: App, css: string, key: string, name: string): Promise<void> {
  await tabTo(app, css);
  await keepDown(app, { down: () => app.hold(key), up: () => app.release(key) }, `${name} down`);
  await says(app, `${name} up`);
}

for (const [module, drawing, pins, engines] of [
  ['microbit', 'svg.microbit', ['pin0', 'pin1', 'pin2'], {}],
  ['calliopemini', 'svg.calliope', ['pin0', 'pin1', 'pin2', 'pin3'], IN_ONE_ENGINE],
] as const) {
  test(`the board of ${module} is used by keyboard alone, from the editor to the REPL`, engines, async ({ app }) => {
    await openApp(app, { language: 'en', robot: 'none' }); // a robot has its sensors on some of the pins
    await pasteProgram(app, program(module, pins));
    expect(await isAt(app, on('editor'))).toBe(true);

    await tabTo(app, on('run'), true);
    await app.press('Enter');
    await says(app, 'ready');
    await expect.poll(() => isThere(app, drawing)).toBe(true);

    await hold(app, `${drawing} [aria-label="Button A"]`, 'Space', 'A');
    await hold(app, `${drawing} [aria-label="Button B"]`, 'Enter', 'B');
    await hold(app, `${drawing} [aria-label="Touch the logo"]`, 'Space', 'logo');
    for (const pin of pins) await hold(app, `${drawing} [aria-label="Touch pin ${pin.slice(3)}"]`, 'Enter', pin);

    await tabTo(app, '[data-testid=panel-sensors]');
    await app.press('Enter');
    await expect.poll(() => isThere(app, '.panel-open input[type=range]')).toBe(true);
    await tabTo(app, '.panel-open [role=slider][aria-label=Tilt]');
    for (let step = 0; step < 4; step += 1) await app.press('ArrowRight');
    await expect.poll(() => consoleIn(app)).toMatch(/tilt (19|20|21)\d\b/);
    await tabTo(app, '[data-testid=shake]');
    await app.press('Space');
    await says(app, 'shaken');
    await tabTo(app, '.panel-open input[type=range]');
    await app.press('End');
    await says(app, 'light 255');

    await tabTo(app, by('console-fold'));
    await app.press('Enter');
    await tabTo(app, '[data-testid=console-input]');
    await app.press('Control', 'c');
    await says(app, 'KeyboardInterrupt');
    await says(app, '>>>');
    await app.type('6 * 7');
    await app.press('Enter');
    await expect.poll(() => consoleIn(app)).toMatch(/>>> 6 \* 7\s+42\s+>>>/);

    await tabTo(app, on('stop'), true);
    await app.press('Enter');
    await expect.poll(() => isEnabled(app, 'stop')).toBe(false);
  });
}

test('Tab leads through the page and its program, which stays as it is; skip links lead to its parts', async ({
  app,
}) => {
  await openApp(app, { language: 'en' });
  const program = await programIn(app);
  await expect(async () => {
    await app.press('Tab');
    expect(await isAt(app, by('skip-program'))).toBe(true);
  }).toPass();
  await app.press('Enter');
  expect(await isAt(app, on('editor'))).toBe(true);
  await expect.poll(() => isThere(app, '.way-out')).toBe(true);
  await app.press('Tab');
  expect(await isAt(app, on('editor'))).toBe(false);
  expect(await programIn(app)).toBe(program);
});

test('the way back of the browser closes what lies open, one after the other, and the work stays', async ({ app }) => {
  await openApp(app, { language: 'en' });
  await pasteProgram(app, 'print("mine")');
  const isOpen = (part: string): Promise<boolean> => isThere(app, by(part));
  const back = async (part: string): Promise<void> => {
    await app.evaluate(() => history.back());
    await expect.poll(() => isOpen(part)).toBe(false);
  };
  await fromMenu(app, by('menu'), by('menu-open'), () => isOpen('open-files'));
  await expect.poll(() => app.evaluate(() => document.querySelector('.app')?.hasAttribute('inert'))).toBe(true);
  await back('open-files');
  expect(await isAt(app, by('menu'))).toBe(true);
  await app.evaluate(() => void (location.hash = '#missions'));
  await expect.poll(() => isOpen('mission-forward')).toBe(true);
  await back('mission-forward');
  expect(await programIn(app)).toBe('print("mine")');
});
