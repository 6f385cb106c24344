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
    await expect(card.getByText('ohne die Wand')).toBeVisible();
    await expect.poll(() => isCovered(page)).toBe(false);
    expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);

    await card.locator(by('next-hint')).click();
    await expect(card.locator(by('hint'))).toHaveText(/Wie weit ist es\?/);
    await page.click(by('task-start'));
    await expect(card).toBeHidden();
    await page.click(by('task'));
    await expect(card.getByText('ohne die Wand')).toBeVisible();
    await expect(card.locator(by('hint'))).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(card).toBeHidden();
    await expect(page.locator(by('task'))).toBeFocused();
  });

test('the task is in reach in full screen', async ({ page }) => {
  await openTask(page, 1366, 768);
  await page.click(by('task-close'));
  await page.click(by('fullscreen'));
  await page.click(by('task'));
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

test('a run makes the card go; opened again it ticks the goals', async ({ page }) => {
  await openTask(page, 1366, 768);
  await page.click(on('run'));
  await expect(page.locator(by('task-card'))).toBeHidden();
  await page.click(by('task'));
  await expect(page.locator(by('task-goals'))).toBeVisible();
});
