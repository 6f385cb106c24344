import type { Page } from '@playwright/test';
import { expect, playwrightApp, test } from './app';
import { violationsOn } from './axe';
import { on, openApp, programIn } from './page';
import { withFingers } from './touch';

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } as const;
const ROW = '[role=toolbar] [data-key]';

/** Whether the whole of each such element is inside the window, and where a finger on its middle would land. */
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
    await openApp(app);
    await fingers.tap('.code-editor .cm-scroller');
    await expect(page.locator(ROW).first()).toBeVisible();
    await page.setViewportSize({ width: 390, height: 520 }); // what a keyboard leaves of it
    await expect(page.locator(ROW).first()).toBeVisible();
    await page.setViewportSize(phone.viewport);
    await expect(page.locator(ROW)).toHaveCount(0);
  });
});

test.describe('with a mouse', () => {
  test.use({ viewport: { width: 1366, height: 625 } });

  test('there are no keys to tap', async ({ page }) => {
    const app = playwrightApp('chromium', page);
    await openApp(app);
    await app.click(on('editor'));
    await expect(page.locator('.code-editor .cm-focused')).toHaveCount(1);
    await expect(page.locator(ROW)).toHaveCount(0);
  });
});
