import { expect, playwrightApp, test, type App } from './app';
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

const WRONG = 'from mbrobot import *\n\nvorwärts()\ndelay(1000)\nstop()';
const RIGHT = WRONG.replace('vorwärts', 'forward');

test('on a school laptop the button that repairs an error is in sight', async ({ page }) => {
  await page.setViewportSize({ width: 1366, height: 625 });
  const app = playwrightApp('chromium', page);
  await openApp(app, { language: 'de' });
  await pasteProgram(app, WRONG);
  await app.click(on('run'));
  await expect(page.locator(CARD)).toHaveText('Ändern in forward');
  const log = (): Promise<{ y: number; height: number } | null> => page.locator(on('console')).boundingBox();
  await expect
    .poll(async () => {
      const [inner, outer] = [await page.locator(CARD).boundingBox(), await log()];
      return inner !== null && outer !== null && inner.y >= outer.y && inner.y + inner.height <= outer.y + outer.height;
    })
    .toBe(true);
  await page.locator(CARD).click();
  await expect.poll(() => programIn(app)).toBe(RIGHT);
});

test('on a phone an error stands in one line below the program, which it does not cover', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const app = playwrightApp('chromium', page);
  await openApp(app, { language: 'de' });
  await page.locator('nav.nav button').nth(0).click();
  await pasteProgram(app, WRONG);
  await app.click(on('run'));
  const line = page.getByTestId('error-line');
  await page.locator('nav.nav button').nth(0).click();
  await expect(line).toContainText('Zeile 3: Meinst du forward?');
  const [low, editor] = [await line.boundingBox(), await page.locator('.code-editor .cm-scroller').boundingBox()];
  expect(low!.y).toBeGreaterThanOrEqual(editor!.y + editor!.height - 1);
  await line.getByRole('button', { name: 'Ändern in forward' }).click();
  await expect.poll(() => programIn(app)).toBe(RIGHT);
  await expect(line).toHaveCount(0);
});

test('by ear: an error is said with its suggestion, and what was printed on request', async ({ app }) => {
  const heard = (): Promise<string> =>
    app.evaluate(() =>
      Array.from(document.querySelectorAll('[role=status]'), ({ textContent }) => textContent).join('\n'),
    );
  await openApp(app, { language: 'de' });
  await pasteProgram(app, 'zahl = 7\nprint("Das ist", zahl)\nprint(zhal)');
  await app.click(on('run'));
  await expect.poll(heard).toContain('Den Namen zhal kennt das Programm nicht. Meinst du zahl?');
  expect(await heard()).not.toContain('Das ist 7');
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid=read-output]')?.click());
  await expect.poll(heard).toContain('Das ist 7');
});
