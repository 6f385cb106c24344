import type { Page } from '@playwright/test';
import { expect, playwrightApp, warmTest as test, type App } from './app';
import { violationsOn } from './axe';
import { on, openApp, pasteProgram, programIn } from './page';
import { withFingers } from './touch';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } as const;
const ROW = '[role=toolbar] [data-key]';

/** True if the whole of each such element is inside the window, and where a finger on its middle would land. */
const reachable = (page: Page, css: string): Promise<readonly string[]> =>
  page.locator(css).evaluateAll((all) =>
    all
      .filter((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect();
        const there = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return left >= 0 && right <= innerWidth && top >= 0 && bottom <= innerHeight && element.contains(there);
      })
      .map((element) => (element as HTMLElement).dataset['key'] ?? ''),
  );

test.describe('with fingers, on a phone', () => {
  test.use(phone);

  test('the keys over the keyboard write without taking the focus, also at 360 px', async ({ page }) => {
    const { app, fingers } = await withFingers(page);
    await openApp(app, { language: 'de' });
    await expect(page.locator(ROW)).toHaveCount(0);
    await fingers.tap('.code-editor .cm-scroller');
    await expect(page.locator(ROW).first()).toBeVisible();
    await app.press('Control', 'a');
    await page.keyboard.insertText('while True');
    await fingers.tap('[data-key=colon]');
    await page.keyboard.press('Enter');
    await page.keyboard.insertText('print');
    await fingers.tap('[data-key=open]');
    await fingers.tap('[data-key=quote]');
    expect(await programIn(app)).toBe('while True:\n    print("');
    await fingers.tap('[data-key=dedent]');
    expect(await programIn(app)).toBe('while True:\nprint("');
    expect(await page.evaluate((css) => document.activeElement?.matches(css), on('editor'))).toBe(true);
    expect(await violationsOn(app)).toEqual([]);

    await page.setViewportSize({ width: 360, height: 640 });
    await page.tap('.code-editor .cm-scroller');
    const inSight = await reachable(page, ROW);
    for (const key of ['indent', 'colon', 'open', 'close', 'quote', 'equals', 'hash']) expect(inSight).toContain(key);
    const sizes = await page.locator(ROW).evaluateAll((all) => all.map((it) => it.getBoundingClientRect()));
    for (const { width, height } of sizes) {
      expect(width).toBeGreaterThanOrEqual(40);
      expect(height).toBeGreaterThanOrEqual(44);
    }
  });

  test('the keys go when the keyboard goes', async ({ page }) => {
    const { app, fingers } = await withFingers(page);
    await openApp(app, { language: 'de' });
    await fingers.tap('.code-editor .cm-scroller');
    await expect(page.locator(ROW).first()).toBeVisible();
    await page.setViewportSize({ width: 390, height: 520 }); // what a keyboard leaves of it
    await expect(page.locator(ROW).first()).toBeVisible();
    await page.setViewportSize(phone.viewport);
    await expect(page.locator(ROW)).toHaveCount(0);
  });
});

const TOGGLE = '[data-testid=commands-toggle]';
const command = (id: string): string => `[data-command=${id}]`;

/** The cursor at the end of a new program. */
async function write(app: App, program: string): Promise<void> {
  await pasteProgram(app, program);
  await app.press('Control', 'End');
}

test.describe('with fingers, on a phone: the commands', () => {
  test.use(phone);

  test('are a sheet over the lower half, write with a tap and leave the keyboard away', async ({ page }) => {
    const { app, fingers } = await withFingers(page);
    await openApp(app, { language: 'de' });
    await fingers.tap(TOGGLE);
    const sheet = page.getByRole('region', { name: 'Befehle', exact: true });
    await expect(sheet.locator(command('forward'))).toContainText('Fährt vorwärts, bis ein anderer Befehl kommt.');
    const box = await sheet.boundingBox();
    expect(box?.y).toBeGreaterThan(844 * 0.4);
    expect(box?.width).toBe(390);
    const before = await programIn(app);
    await fingers.tap(command('stop'));
    expect(await programIn(app)).toBe(`${before}stop()`); // nobody has chosen another place
    expect(await page.evaluate((css) => document.activeElement?.matches(css), on('editor'))).toBe(false);
    expect(await violationsOn(app)).toEqual([]);
    await fingers.tap('[data-group=repeat]');
    await fingers.tap(command('times'));
    expect(await programIn(app)).toContain('stop()\nfor i in range(4):\n    ');
    await fingers.tap(TOGGLE);
    await expect(sheet).toHaveCount(0);
  });
});

test.describe('with a mouse', () => {
  test.use({ viewport: { width: 1366, height: 625 } });

  test('a click writes a command with its import, values marked, and one step takes it back', async ({ page }) => {
    const app = playwrightApp('chromium', page);
    await openApp(app, { language: 'de', robot: 'maqueen-lite' });
    await write(app, 'print("los")');
    await app.click(TOGGLE);
    await app.click(command('setSpeed'));
    expect(await programIn(app)).toBe('from mbrobot import *\nprint("los")\nsetSpeed(50)');
    await app.type('80');
    await app.click('[data-group=repeat]');
    await app.click(command('forever'));
    await app.click('[data-group=drive]');
    await app.click(command('forward'));
    const program = 'from mbrobot import *\nprint("los")\nsetSpeed(80)\nwhile True:\n    forward()';
    expect(await programIn(app)).toBe(program);
    expect(await violationsOn(app)).toEqual([]);
    await app.press('Control', 'z');
    expect(await programIn(app)).toBe(program.replace('forward()', ''));
  });

  test('a command that is dragged goes where it is dropped', async ({ page }) => {
    const app = playwrightApp('chromium', page);
    await openApp(app, { language: 'de', robot: 'maqueen-lite', showCommands: true });
    await write(app, 'from mbrobot import *\nwhile True:\n    left()\nbeep()');
    const lines = page.locator('.code-editor .cm-line');
    await page.locator(command('stop')).dragTo(lines.nth(2), { targetPosition: { x: 60, y: 18 } });
    expect(await programIn(app)).toBe('from mbrobot import *\nwhile True:\n    left()\n    stop()\nbeep()');
    await page.locator(command('right')).dragTo(lines.nth(4), { targetPosition: { x: 30, y: 3 } });
    expect(await programIn(app)).toBe('from mbrobot import *\nwhile True:\n    left()\n    stop()\nright()\nbeep()');
  });

  test('the palette is for the chosen robot, in its language, and is open again after a reload', async ({ page }) => {
    const app = playwrightApp('chromium', page);
    await openApp(app, { language: 'fr', robot: 'none', device: 'microbit-v2' });
    await app.click(TOGGLE);
    await expect(page.locator('[data-group]')).toHaveCount(8);
    await expect(page.locator('[data-group=show]')).toHaveText('Afficher');
    await page.reload();
    await expect(page.locator(command('scroll'))).toContainText('Faire défiler un texte');
    await page.getByRole('button', { name: 'Fermer les commandes' }).click();
    await expect(page.locator('[data-group]')).toHaveCount(0);
  });

  test('there are no keys to tap', async ({ page }) => {
    const app = playwrightApp('chromium', page);
    await openApp(app);
    await app.click(on('editor'));
    await expect(page.locator('.code-editor .cm-focused')).toHaveCount(1);
    await expect(page.locator(ROW)).toHaveCount(0);
  });
});
