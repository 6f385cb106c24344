import type { Page } from '@playwright/test';
import { projectOfLink } from '../src/project/link/link';
import { expect, playwrightApp, test } from './app';
import { classLink } from './class-link';
import { on, programIn } from './page';
import { by } from './parts';

/** How often a newcomer presses something before an own program passes the first mission. */
const MOST = 5;

/** Three commands below the import; how long the robot has to drive, the newcomer has found out. */
const PROGRAM = ['from mbrobot import *', 'forward()', 'delay(2000)', 'stop()'];

/** Counts what is really pressed in the page, whoever presses it. */
async function countPresses(page: Page): Promise<() => Promise<number>> {
  await page.addInitScript(() => {
    addEventListener('pointerdown', () => (document.documentElement.dataset['presses'] = String(presses() + 1)), true);
    const presses = (): number => Number(document.documentElement.dataset['presses'] ?? 0);
  });
  return () => page.evaluate(() => Number(document.documentElement.dataset['presses'] ?? 0));
}

/** Types a program in place of the one that is there. */
async function typeOver(page: Page, lines: readonly string[]): Promise<void> {
  await page.keyboard.press('Control+a');
  for (const [at, line] of lines.entries()) {
    if (at > 0) await page.keyboard.press('Enter');
    await page.keyboard.insertText(line);
  }
}

const passed = (page: Page): Promise<void> =>
  expect.poll(() => page.getAttribute(by('verdict'), 'data-state')).toBe('passed');

test.describe('on a school laptop, with the mouse', () => {
  test.use({ viewport: { width: 1366, height: 625 }, locale: 'de-CH' });

  test('a newcomer passes the first mission with a program of their own in five clicks', async ({ page }) => {
    const presses = await countPresses(page);
    await page.goto('./');
    await page.click(by('welcome-robot'));
    await page.click(on('editor'));
    await typeOver(page, PROGRAM);
    expect(await programIn(playwrightApp('chromium', page))).toBe(PROGRAM.join('\n'));
    await page.click(by('run'));
    await passed(page);
    await page.waitForSelector(by('next-mission'));
    expect(await presses()).toBeLessThanOrEqual(MOST);
  });
});

test.describe('on a phone, by touch', () => {
  test.use({ viewport: { width: 390, height: 844 }, locale: 'de-CH', hasTouch: true, isMobile: true });

  test('a newcomer passes the first mission with a program of their own in five taps', async ({ page }) => {
    const presses = await countPresses(page);
    await page.goto('./');
    await page.tap(by('welcome-robot'));
    await page.waitForSelector(by('task-card'));
    await page.tap(by('peek')); // leads to the program
    await page.tap(on('editor'));
    await typeOver(page, PROGRAM);
    expect(await programIn(playwrightApp('chromium', page))).toBe(PROGRAM.join('\n'));
    await page.tap(by('run'));
    await passed(page);
    await page.waitForSelector(by('next-mission'));
    expect(await presses()).toBeLessThanOrEqual(MOST);
  });

  test('a class’s task is solved from its link and handed in with four taps besides typing', async ({ page }) => {
    const presses = await countPresses(page);
    await page.addInitScript(() => {
      const share = (data: ShareData): Promise<void> =>
        Promise.resolve(void (document.documentElement.dataset['shared'] = data.url));
      Object.defineProperty(navigator, 'share', { value: share });
    });
    await page.goto(classLink());
    await page.waitForSelector(by('task-card'));
    expect(await page.locator(by('welcome')).count()).toBe(0);
    await page.tap(by('peek')); // leads to the program
    await page.tap(on('editor'));
    await typeOver(page, PROGRAM);
    await page.tap(by('run'));
    await passed(page);
    await expect(page.locator(by('next-mission'))).toHaveCount(0);
    await page.tap(by('step-hand-in'));
    await expect(page.locator(by('hand-in-name'))).toBeFocused();
    await page.keyboard.press('Enter'); // not without a name
    await expect(page.locator(by('hand-in-need'))).not.toBeEmpty();
    await page.keyboard.insertText('Elif K.');
    await expect(page.locator(by('hand-in-state'))).toContainText('bestanden', { timeout: 30_000 });
    await page.keyboard.press('Enter');
    await expect.poll(() => page.getAttribute('html', 'data-shared')).toContain('#');
    expect(await presses()).toBeLessThanOrEqual(4);
    const read = projectOfLink(new URL((await page.getAttribute('html', 'data-shared')) ?? '').hash, () => null);
    expect(read).toMatchObject({ project: { handIn: { alias: 'Elif K.', verdict: 'passed' } } });
    await page.tap(by('hand-in-close'));
    await expect(page.locator(by('step-hand-in'))).toHaveText('Nochmals abgeben');
  });
});
