import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { openApp, typeProgram } from './page';
import { openMenu } from './pupil';

const PANEL = '[data-testid=device-check]';
const MARK = '.cm-deviceMark';

const CARD = '.cm-helpCard';

/** The present text of an element; empty if it does not exist. */
const textOf = (app: App, css: string): Promise<string> =>
  app.evaluate((selector) => document.querySelector(selector)?.textContent ?? '', css);

test(
  'what does not run on the device is marked, explained in its line, and no longer once it is mended',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    const has = (css: string) => app.evaluate((selector) => document.querySelector(selector) !== null, css);
    await typeProgram(app, 'x = 3\nprint(f"{x}")');
    await expect.poll(() => has(MARK), { timeout: 10_000 }).toBe(true);
    expect(await app.text(PANEL)).toContain('"{}".format(x)');

    await app.press('ArrowUp');
    await expect.poll(() => app.text(PANEL)).not.toContain('format');
    await app.press('F8');
    await expect.poll(() => app.text(PANEL)).toContain('"{}".format(x)');

    await typeProgram(app, 'x = 3\nprint("{}".format(x))');
    await expect.poll(() => has(PANEL)).toBe(false);
  },
);

test(
  'the marks and the help speak the language of the page, also when another one is chosen',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'fr' });
    await typeProgram(app, 'from microbit import *\nprint(f"{temperature()}")');
    await expect.poll(() => app.text(PANEL), { timeout: 10_000 }).toContain('Écris plutôt "{}".format(temperature())');
    await app.press('Home');
    await app.press('Control', 'Shift', 'Space');
    await expect.poll(() => textOf(app, CARD)).toContain('Écrit des valeurs dans la console');
    await app.press('Escape');

    const isItalian = (): Promise<boolean> => app.evaluate(() => document.documentElement.lang === 'it-CH');
    await openMenu(app, 'language');
    await app.click('[role=menuitemradio][lang=it]');
    await expect.poll(isItalian).toBe(true);
    await expect.poll(() => textOf(app, PANEL)).toContain('Scrivi invece "{}".format(temperature())');
    await app.click('.code-editor .cm-line:last-child');
    await app.press('Home');
    await app.press('Control', 'Shift', 'Space');
    await expect.poll(() => textOf(app, CARD)).toContain('Scrive valori nella console');
  },
);
