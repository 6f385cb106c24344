import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { attribute, consoleIn, isThere, keepDown, on, openApp, pasteProgram } from './page';

test(
  'a Calliope mini shows itself as soon as it is imported, with its colours, its motors and its fourth pin',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await pasteProgram(app, 'from microbit import *\n');
    await expect.poll(() => isThere(app, 'svg.microbit')).toBe(true);
    await pasteProgram(
      app,
      [
        'from calliopemini import *',
        'from neopixel import NeoPixel',
        'lights = NeoPixel(pin_RGB, 3)',
        'lights[0] = (255, 0, 0)',
        'lights[2] = (0, 0, 80)',
        'lights.show()',
        'pin_M_MODE.write_digital(1)',
        'pin_M0_DIR.write_digital(0)',
        'pin_M0_SPEED.write_analog(512)',
        'pin_M1_DIR.write_digital(1)',
        'pin_M1_SPEED.write_analog(256)',
        'print("ready")',
        'while True:',
        '    while not pin3.is_touched(): pass',
        '    print("touched")',
        '    while pin3.is_touched(): pass',
        '    print("let go")',
      ].join('\n'),
    );
    await expect.poll(() => isThere(app, 'svg.calliope')).toBe(true);
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('ready');

    await expect
      .poll(() => attribute(app, '[aria-label^="Colour lights"]', 'aria-label'))
      .toContain('255 0 0, 0 0 0, 0 0 80');
    await expect.poll(() => attribute(app, '[aria-label^="Motors"]', 'aria-label')).toBe('Motors: M0 50 %, M1 −25 %');

    const pin3 = 'svg.calliope [aria-label="Touch pin 3"]';
    await keepDown(app, { down: () => app.grab(pin3), up: () => app.letGo() }, 'touched');
    await expect.poll(() => consoleIn(app)).toContain('let go');
  },
);
