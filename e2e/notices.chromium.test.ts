import type { Page } from '@playwright/test';

import { linkOf } from '../src/project/link/link';
import { taskProject } from '../src/project/testing/projects';
import { expect, playwrightApp, warmTest as test } from './app';
import { openApp, pasteProgram } from './page';

/** A link that is opened over a pupil's own work: its message says so, and offers to take it back. */
function link(): string {
  const made = linkOf(taskProject(), { courses: () => null, program: true });
  if (made === null) throw new Error('There is no link.');
  return `./#${made.fragment}`;
}

/** The things that the message covers: controls by their names, and the middle of the course. */
const covered = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => {
    const notice = document.querySelector('.notice')?.getBoundingClientRect();
    if (notice === undefined) return ['no message'];
    const RIM_PX = 4; // what is drawn of a control, as the logo of the board, ends within where it can be touched
    const meets = (box: { left: number; right: number; top: number; bottom: number }): boolean =>
      Math.min(box.right, notice.right) - Math.max(box.left, notice.left) > RIM_PX &&
      Math.min(box.bottom, notice.bottom) - Math.max(box.top, notice.top) > RIM_PX;
    const controls = [
      ...document.querySelectorAll<HTMLElement>('button, a, input, select, [role=button], [role=slider]'),
    ]
      .filter((one) => one.closest('.notice') === null && one.checkVisibility({ visibilityProperty: true }))
      .filter((one) => meets(one.getBoundingClientRect()))
      .map((one) => one.getAttribute('aria-label') ?? one.textContent.trim());
    const floor = document.querySelector('.pane-arena .floor')?.getBoundingClientRect();
    if (floor === undefined) return controls;
    const third = { x: floor.width / 3, y: floor.height / 3 };
    const middle = {
      ...{ left: floor.left + third.x, right: floor.right - third.x },
      ...{ top: floor.top + third.y, bottom: floor.bottom - third.y },
    };
    return meets(middle) ? [...controls, 'the middle of the course'] : controls;
  });

for (const { width, height, isTouch, language } of [
  { width: 1366, height: 625, isTouch: false, language: 'de' },
  { width: 1024, height: 768, isTouch: true, language: 'fr' },
  { width: 820, height: 1180, isTouch: true, language: 'de' },
  { width: 390, height: 844, isTouch: true, language: 'fr' },
] as const)
  test.describe(`on ${String(width)} × ${String(height)} px`, () => {
    test.use({ viewport: { width, height }, hasTouch: isTouch, isMobile: isTouch });

    test(`a message covers no control and not the middle of the course, ${language}`, async ({ page }) => {
      const app = playwrightApp('chromium', page);
      await openApp(app, { language, welcomed: true });
      await pasteProgram(app, 'print("mine")');
      await page.goto(link());
      await expect(page.locator('.notice .do')).toBeVisible();
      await expect.poll(() => covered(page)).toEqual([]);
      await expect.poll(() => covered(page)).toEqual([]);
      for (const tab of await page.locator('nav.nav button').all()) {
        await tab.tap();
        await expect.poll(() => covered(page)).toEqual([]);
      }
    });
  });
