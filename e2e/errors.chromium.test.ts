import { expect, test, type App } from './app';
import { consoleIn, on, openApp, pasteProgram, programIn } from './page';
import { until } from './parts';

const CARD = '.ways .mend';

/** Runs the program and taps the button of the error's card. */
async function mendBy(app: App, label: string): Promise<void> {
  await app.click(on('run'));
  await until(app, CARD);
  expect(await app.text(CARD)).toBe(label);
  await app.click(CARD);
}

test('a forgotten import is put in by a tap, and the program runs', async ({ app }) => {
  await openApp(app, { language: 'de' });
  await pasteProgram(app, '# Bild\ndisplay.show(Image.HEART)\nprint("fertig")');
  await mendBy(app, 'from microbit import * einfügen');
  const mended = '# Bild\nfrom microbit import *\ndisplay.show(Image.HEART)\nprint("fertig")';
  await expect.poll(() => programIn(app)).toBe(mended);
  await app.press('Control', 'z');
  await expect.poll(() => programIn(app)).not.toContain('import');
  await app.press('Control', 'y');
  await expect.poll(() => programIn(app)).toBe(mended);
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('fertig');
});

test('repeat becomes a loop of Python by a tap, and the program runs', async ({ app }) => {
  await openApp(app, { language: 'de' });
  await pasteProgram(app, 'repeat 4:\n    print("hopp")');
  await mendBy(app, 'Ändern in for i in range(4):');
  await expect.poll(() => programIn(app)).toBe('for i in range(4):\n    print("hopp")');
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toMatch(/(hopp\s+){4}/);
});

test('the editor tells of a command without brackets and writes them', async ({ app }) => {
  await openApp(app, { language: 'de' });
  await pasteProgram(app, 'from microbit import *\ndisplay.clear');
  const panel = '[data-testid=device-check]';
  const saying = (): Promise<string> => app.evaluate((css) => document.querySelector(css)?.textContent ?? '', panel);
  await expect.poll(saying, { timeout: 10_000 }).toContain('Ohne Klammern tut display.clear nichts.');
  await app.click(`${panel} button`);
  await expect.poll(() => programIn(app)).toBe('from microbit import *\ndisplay.clear()');
});
