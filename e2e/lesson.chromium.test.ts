import type { Page } from '@playwright/test';

import type { Point } from '../src/scene/scene';
import { expect, playwrightApp, warmTest as test } from './app';
import { inWindow } from './arena';
import { by } from './parts';
import { SIZE } from './pupil';

test.use({ locale: 'de-CH', viewport: { width: 1366, height: 768 } });

/** A teacher whose gestures are counted: a click, a drag, a key and a line that is typed are one each. */
function teacher(page: Page) {
  const gestures: string[] = [];
  const app = playwrightApp('chromium', page);
  const mouse = async (places: readonly Point[]): Promise<void> => app.draw(await inWindow(app, SIZE, places));
  return {
    gestures,
    click: async (css: string): Promise<void> => {
      gestures.push(`click ${css}`);
      await page.click(css);
    },
    tool: async (id: string): Promise<void> => {
      gestures.push(`tool ${id}`);
      await page.click(`[data-tool=${id}]`);
      await expect(page.locator(by('arena'))).not.toHaveCSS('cursor', 'progress');
    },
    drag: async (...places: readonly Point[]): Promise<void> => {
      gestures.push(`drag to ${String(places.at(-1))}`);
      await mouse(places);
    },
    /** From the shelf onto the course. */
    dragPart: async (id: string, place: Point): Promise<void> => {
      gestures.push(`drag ${id}`);
      const card = page.locator(by(`part-${id}`));
      await card.scrollIntoViewIfNeeded();
      const box = await card.boundingBox();
      const [to] = await inWindow(app, SIZE, [place]);
      if (box === null || to === undefined) throw new Error(`${id} is not there.`);
      await page.mouse.move(box.x + 40, box.y + 40);
      await page.mouse.down();
      await page.mouse.move(to.x - 40, to.y, { steps: 4 });
      await page.mouse.move(to.x, to.y, { steps: 4 });
      await page.mouse.up();
    },
    press: async (keys: string): Promise<void> => {
      gestures.push(`press ${keys}`);
      await page.keyboard.press(keys);
    },
    type: async (...lines: readonly string[]): Promise<void> => {
      gestures.push(...lines.map((line) => `type ${line}`));
      await page.keyboard.insertText(lines.join('\n'));
    },
    /** Opens a list and takes one of its entries. */
    choose: async (css: string, value: string): Promise<void> => {
      gestures.push(`open ${css}`, `choose ${value}`);
      await page.selectOption(css, value);
    },
  };
}

test('a lesson from the empty arena to the projector takes 60 gestures at most', async ({ page }) => {
  test.setTimeout(150_000);
  const { gestures, click, tool, drag, dragPart, press, type, choose } = teacher(page);
  const step = page.locator(by('maker-step'));
  await page.goto('./logo.svg');
  await page.evaluate(() => localStorage.setItem('parcours.settings', '{"language":"de","welcomed":true}'));
  await page.goto('./');
  // The course: a line, the start, a garage with its target, a block that moves.
  await click('header .course');
  await click(by('empty-arena'));
  await tool('pen');
  await drag([600, 100], [600, 300], [600, 500], [600, 650]);
  await tool('start');
  await drag([600, 120], [600, 160], [600, 220]);
  await click(by('bench-parts'));
  await dragPart('garage', [600, 720]);
  await click(by('close-parts'));
  await tool('block');
  await click('.pane-bench [aria-label="Fährt selbst"]');
  await drag([400, 430], [500, 430], [800, 430]);
  // The card, with a title, a text and a hint.
  await click(by('menu'));
  await click(by('menu-teachers'));
  await click(by('menu-task'));
  await click(by('maker-title'));
  await type('Ab in die Garage');
  await click(by('maker-text'));
  await expect(page.locator(`textarea${by('maker-text')}`)).toBeFocused();
  await type('Warte, bis der Weg frei ist, und fahr in die Garage.');
  await click(by('maker-add-hint'));
  await expect(page.locator(`textarea${by('maker-hint')}`)).toBeFocused();
  await type('Der Ultraschall sieht den Block.');
  await expect(page.locator(by('maker-title'))).toHaveValue('Ab in die Garage');
  // Three more checks, two hidden worlds.
  for (const check of ['stop', 'touches', 'loop']) await choose(by('maker-add-check'), check);
  await click(by('maker-add-world'));
  await click(by('maker-add-world'));
  // The model solution: it touches the block at first.
  await click(by('maker-act'));
  await expect(page.locator(by('maker-code'))).toBeFocused();
  await press('Control+a');
  await type(
    'from mbrobot import *',
    'setSpeed(80)',
    'forward()',
    'while getDistance() > 10:',
    '    delay(10)',
    'stop()',
  );
  await expect(step).toContainText(/besteht (nicht|in [12] von 3)/, { timeout: 30_000 });
  await click(`${by('maker-code')} .cm-line:nth-child(2)`);
  await press('End');
  await type('', 'while getDistance() > 40:', '    delay(10)', 'while getDistance() < 40:', '    delay(10)');
  await expect(step).toContainText('besteht in allen 3 Welten', { timeout: 30_000 });
  // The start program, the course that stays as it is.
  await click(by('maker-start'));
  await click(by('maker-code'));
  await press('Control+a');
  await type('from mbrobot import *', '');
  await click(by('maker-menu'));
  await click(by('maker-locks-open'));
  await click(by('maker-lock-course'));
  await click(by('maker-window-close'));
  // For the class: the file, the worksheet as PDF; then the projector.
  await click(by('maker-act'));
  await click(by('maker-save-for-class'));
  await click(by('maker-give-sheet'));
  await expect(page.locator(by('sheet-page')).first()).toBeVisible();
  const [pdf] = await Promise.all([page.waitForEvent('download'), click(by('sheet-pdf'))]);
  expect(pdf.suggestedFilename()).toMatch(/Ab in die Garage.*\.pdf$/);
  await press('Escape');
  await click(by('maker-give-show'));
  await expect(page.locator(by('projector'))).toContainText('Ab in die Garage');
  expect(gestures.length, gestures.join('\n')).toBeLessThanOrEqual(60);
});
