import type { Page } from '@playwright/test';

import { linkOf } from '../src/project/link/link';
import { taskProject } from '../src/project/testing/projects';
import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { on } from './page';
import { by } from './parts';

/** A link with a task in two languages, hints and a picture. */
function taskLink(): string {
  const made = linkOf(taskProject(), { courses: () => null, program: true });
  if (made === null) throw new Error('There is no link.');
  return `./#${made.fragment}`;
}

/** Opens the link as somebody who was never here. */
async function openTask(page: Page, width: number, height: number): Promise<void> {
  await page.setViewportSize({ width, height });
  await page.goto(taskLink());
  await page.waitForSelector(by('task-card'));
}

const isCovered = (page: Page): Promise<boolean> =>
  page.evaluate(
    ([card, floor]) => {
      const [a, b] = [card, floor].map((css) => document.querySelector(css ?? '')?.getBoundingClientRect());
      if (a === undefined || b === undefined) return true;
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      return width > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
    },
    [by('task-card'), '.pane-arena .floor'],
  );

for (const [width, height] of [
  [1366, 625],
  [820, 1180],
  [390, 844],
] as const)
  test(`a task in a link is read beside the course in a fresh profile, ${width} by ${height}`, async ({ page }) => {
    await openTask(page, width, height);
    const card = page.locator(by('task-card'));
    await expect(card.getByRole('heading', { name: 'Rückwärts einparken' })).toBeVisible();
    await expect(card.locator('strong')).toHaveText('grüne');
    const text = page.locator(by('task-text'));
    await expect(text.getByText('ohne die Wand')).toBeVisible();
    await expect.poll(() => isCovered(page)).toBe(false);
    expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);

    await card.locator(by('next-hint')).click();
    await expect(card.locator(by('hint'))).toHaveText(/Wie weit ist es\?/);
    await page.click(by('task-close'));
    await expect(text.getByText('ohne die Wand')).toBeHidden();
    await page.click(by('task-open'));
    await expect(card.locator(by('hint'))).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(card.locator(by('hint')), 'it covers nothing, so nothing closes it').toHaveCount(1);
  });

test('the task is in reach in full screen', async ({ page }) => {
  await openTask(page, 1366, 768);
  await page.click(by('show'));
  await page.click(by('fullscreen'));
  await expect(page.locator(by('task-text'))).toBeVisible();
  await expect.poll(() => isCovered(page)).toBe(false);
});

test('the task comes in the language of the reader', async ({ browser }) => {
  const page = await (await browser.newContext({ locale: 'fr-CH' })).newPage();
  await openTask(page, 1366, 768);
  await expect(page.getByRole('heading', { name: 'Se garer' })).toBeVisible();
  await expect(page.locator(by('task-text')).locator('strong')).toHaveText('champ');
  await page.context().close();
});

test('the card stays beside program and course during a run, and ticks the goals', async ({ page }) => {
  await openTask(page, 1366, 768);
  await page.click(on('run'));
  await expect(page.locator(by('task-goals'))).toBeVisible();
  await expect.poll(() => isCovered(page)).toBe(false);
});

test('the keys are on the heading of a task that was just opened', async ({ page }) => {
  await openTask(page, 1366, 768);
  await expect(page.locator(by('task-card')).getByRole('heading', { level: 2 })).toBeFocused();
});

for (const [width, height, leastPx] of [
  [1366, 625, 240],
  [1180, 820, 220], // the card is as high as its text there, and leaves the program a least height
  [820, 1180, 300],
] as const)
  test(`program, card and small board are seen together, ${width} by ${height}`, async ({ page }) => {
    await openTask(page, width, height);
    for (const css of ['.pane-code', by('task-card'), '.pane-board', '.pane-arena', '.pane-console'])
      await expect(page.locator(css)).toBeInViewport({ ratio: 1 });
    const [code, board] = await Promise.all(
      ['.pane-code', '.pane-board'].map((css) => page.locator(css).boundingBox()),
    );
    expect(code?.height).toBeGreaterThan(leastPx);
    expect(board?.height).toBeLessThan(150);
    await page.click(by('board-whole'));
    await expect(page.locator(by('panel-sensors'))).toBeVisible();
    await expect(page.locator(by('task-open'))).toBeVisible();
  });
