import type { Page } from '@playwright/test';
import { expect, warmTest as test } from './app';
import { on } from './page';
import { by } from './parts';

/** Opens the page in a window of this size, as somebody finds it who was there before. */
async function openAt(page: Page, width: number, height: number, settings: object = {}): Promise<void> {
  await page.setViewportSize({ width, height });
  const text = JSON.stringify({ language: 'it', welcomed: true, ...settings });
  await page.goto('./logo.svg'); // its storage is the app's, and it loads in no time
  await page.evaluate((kept) => sessionStorage.setItem('parcours.settings', kept), text);
  await page.goto('./');
  await page.waitForSelector(on('editor'));
}

/** How many px of a part of the page lie under another part. */
const covered = (page: Page, part: string, other: string): Promise<number> =>
  page.evaluate(
    ([one, two]) => {
      const [a, b] = [one, two].map((css) => document.querySelector(css ?? '')?.getBoundingClientRect());
      if (a === undefined || b === undefined) throw new Error(`There is no ${one ?? ''} or ${two ?? ''}.`);
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      return Math.max(0, width) * Math.max(0, height);
    },
    [part, other],
  );

for (const [width, height] of [
  [820, 1180],
  [1024, 768],
  [1280, 800],
  [1440, 900],
  [1920, 1080],
] as const)
  test(`the help covers neither program nor arena in a window of ${width} by ${height}, and the board comes back`, async ({
    page,
  }) => {
    await openAt(page, width, height);
    const board = await page.locator('.pane-board').boundingBox();
    await page.click(by('menu'));
    await page.click(by('menu-help'));
    await page.waitForSelector(by('guide-search'));
    for (const part of ['.pane-code', '.pane-arena', '.pane-console'])
      await expect.poll(() => covered(page, part, '.guide'), part).toBe(0);
    expect((await page.locator('.pane-arena').boundingBox())?.width).toBeGreaterThan(320);
    await page.click(by('guide-close'));
    await expect.poll(() => page.locator('.pane-board').boundingBox()).toEqual(board);
  });

test('on a low phone the arena has the display and the buttons of the board above it once the card is folded', async ({
  page,
}) => {
  await openAt(page, 360, 640);
  await page.click('nav >> text=Arena');
  await page.click(by('task-close'));
  await expect(page.locator('.pane-arena .mini')).toBeVisible();
  await page.click(by('mode-build'));
  await expect(page.locator('.pane-arena .mini')).toBeHidden();
});

test('no line of a program goes on out of sight', async ({ page }) => {
  await openAt(page, 390, 844);
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(`if True:\n    print("${'Una frase lunga '.repeat(8)}")\n`);
  const box = page.locator('.code-editor .cm-scroller');
  await expect.poll(() => box.evaluate((it) => it.scrollWidth - it.clientWidth)).toBe(0);
});

test('a page of the board alone that speaks no dialect has the colours of its theme behind the panes', async ({
  page,
}) => {
  const behind = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await page.goto('simulator.html?dialect=none&theme=dark');
  await page.waitForSelector('.pane-board');
  await expect.poll(behind).toBe('rgb(16, 19, 23)');
  await page.goto('simulator.html?theme=dark');
  await page.waitForSelector('.pane-board');
  await expect.poll(behind).toBe('rgba(0, 0, 0, 0)');
});

test('an error asks whether a command was meant that is written almost alike', async ({ page }) => {
  await openAt(page, 1280, 800);
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('from mbrobot import *\nforwart()\n');
  await page.click(on('run'));
  await expect(page.locator(`${on('console')} .card`)).toContainText('Volevi dire forward?');
});
