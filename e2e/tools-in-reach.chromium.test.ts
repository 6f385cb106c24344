import type { Page } from '@playwright/test';
import { expect, playwrightApp, warmTest as test } from './app';
import { openApp } from './page';
import { by } from './parts';
import { toolButton, toolsCame } from './pupil';

/** Which of these things are cut off or covered: a finger that lands at the left, middle or right of one misses it. */
const outOfReach = (page: Page, css: string): Promise<readonly string[]> =>
  page.locator(css).evaluateAll((all) =>
    all
      .filter((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect();
        const lands = (x: number, y: number): boolean => element.contains(document.elementFromPoint(x, y));
        const middle = (top + bottom) / 2;
        const isWhole = left >= 0 && right <= innerWidth && top >= 0 && bottom <= innerHeight;
        return !isWhole || ![left + 4, (left + right) / 2, right - 4].every((x) => lands(x, middle));
      })
      .map((element) => (element as HTMLElement).dataset['tool'] ?? element.getAttribute('aria-label') ?? ''),
  );

const LOOKS = [
  { width: 390, height: 844, isTouch: true },
  { width: 360, height: 640, isTouch: true },
  { width: 844, height: 390, isTouch: true },
  { width: 1024, height: 768, isTouch: true },
  { width: 1100, height: 640, isTouch: false },
];

for (const { width, height, isTouch } of LOOKS)
  test.describe(`on ${width} × ${height} px`, () => {
    test.use({ viewport: { width, height }, hasTouch: isTouch, isMobile: isTouch });
    for (const language of ['de', 'fr'] as const)
      test(`every tool, the bin and the magnet are in reach, ${language}`, async ({ page }) => {
        const app = playwrightApp('chromium', page);
        const use = (css: string): Promise<void> => (isTouch ? page.tap(css) : page.click(css));
        await openApp(app, { language, welcomed: true });
        const arena = page.locator('nav.nav button').nth(2);
        if (await arena.isVisible()) await arena.tap();
        await use(by('mode-build'));
        await expect(page.locator('[data-tool]')).toHaveCount(12);
        expect(await outOfReach(page, '[data-tool]')).toEqual([]);

        const press = async (tool: string): Promise<void> => {
          await use(toolButton(tool));
          await toolsCame(app);
          await (isTouch ? page.locator('[role=application]').tap() : page.locator('[role=application]').click());
        };
        await press('block');
        await press('select');
        await expect(page.locator(by('remove'))).toBeVisible();
        await expect(page.locator(by('magnet'))).toBeVisible();
        expect(await outOfReach(page, `${by('remove')}, ${by('magnet')}, ${by('undo')}`)).toEqual([]);
      });
  });
