import type { Page } from '@playwright/test';

import { expect, playwrightApp, warmTest as test } from './app';
import { enterMode, on, pasteProgram } from './page';
import { by } from './parts';

/** Most buttons, tabs and sliders in sight in each state of the page. */
const MOST = { first: 20, mission: 24, driving: 26, notYet: 28, error: 28, build: 32, lookBack: 29 } as const;
/** A phone begins with fewer. */
const MOST_ON_PHONE = { ...MOST, first: 12 } as const;

const SIZES = [
  { width: 1366, height: 625, most: MOST },
  { width: 1180, height: 820, most: MOST },
  { width: 390, height: 844, most: MOST_ON_PHONE },
] as const;

/** Names of the controls whose middle is seen and not covered. */
const inSight = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const isSeen = (control: Element): boolean => {
      const { left, top, width, height } = control.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      if (width < 2 || height < 2 || x < 0 || y < 0 || x > innerWidth || y > innerHeight) return false;
      const there = document.elementFromPoint(x, y);
      return there !== null && (control.contains(there) || there.contains(control));
    };
    return [...document.querySelectorAll('button, a[href], [role=tab], [role=slider], [role=radio], [role=switch]')]
      .filter(isSeen)
      .map((control) => control.getAttribute('data-testid') ?? control.getAttribute('aria-label') ?? '');
  });

for (const { width, height, most } of SIZES)
  test(`what is in sight belongs to what is done now, ${width} by ${height}`, async ({ page }) => {
    const app = playwrightApp('chromium', page);
    const isFew = async (state: keyof typeof MOST): Promise<void> => {
      await expect.poll(async () => (await inSight(page)).length, state).toBeGreaterThan(5);
      const names = await inSight(page);
      expect.soft(names.length, `${state}: ${names.join(', ')}`).toBeLessThanOrEqual(most[state]);
    };
    /** Runs another program; on a phone it lies behind a tab. */
    const runOther = async (program: string): Promise<void> => {
      if (width < 600) await page.locator('nav').getByText('Code', { exact: true }).click();
      await pasteProgram(app, `from mbrobot import *\n${program}`);
      await app.press('Control', 'Enter');
    };
    await page.setViewportSize({ width, height });
    await page.goto('./');
    await page.waitForSelector(by('welcome'));
    await isFew('first');
    await page.click(by('welcome-robot'));
    await page.waitForSelector(by('task-card'));
    await isFew('mission');
    await page.click(on('run'));
    await page.waitForSelector(by('step-hint'));
    await isFew('notYet');
    await enterMode(app, 'lookBack');
    await page.waitForSelector(by('time-rail'));
    await isFew('lookBack');
    await enterMode(app, 'build');
    await page.waitForSelector(by('step-try'));
    await isFew('build');
    await enterMode(app, 'drive');
    await runOther('while True:\n    left()\n    delay(10)\n');
    await page.waitForSelector('[data-step="drives"]');
    await isFew('driving');
    await runOther('forwart()\n');
    await page.waitForSelector('[data-step="error"]');
    await isFew('error');
  });
