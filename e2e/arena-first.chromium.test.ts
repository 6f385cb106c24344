import type { Page } from '@playwright/test';
import { LANGUAGES } from '../src/core/languages';
import { PANES, type Pane } from '../src/web/session/layout/layout-model';
import { expect, playwrightApp, warmTest as test } from './app';
import { on, openApp } from './page';
import { by } from './parts';

/** The least width of the first course, in CSS px, in windows of this size. */
const LEAST_PX = [
  [1366, 768, 620],
  [1366, 625, 480],
  [1280, 585, 440],
  [1024, 768, 480],
  [1100, 640, 460],
] as const;

/** All sizes at which nothing may be cut off. */
const SIZES = [
  ...LEAST_PX.map(([width, height]) => [width, height] as const),
  [820, 1180],
  [390, 844],
  [844, 390],
  [683, 312],
  [360, 640],
] as const;

/** Opens the page in a window of this size, as somebody finds it who was there before. */
async function openAt(page: Page, [width, height]: readonly [number, number], settings: object = {}): Promise<void> {
  await page.setViewportSize({ width, height });
  await openApp(playwrightApp('chromium', page), { welcomed: true, ...settings });
}

/** Width of the course on the page in px: that of its floor on the lowest canvas. */
const courseWidth = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('[data-testid=arena] canvas');
    const context = canvas?.getContext('2d');
    if (!canvas || !context) throw new Error('There is no arena.');
    const ratio = canvas.width / canvas.getBoundingClientRect().width;
    // A row in the middle of the course: from its left edge to its right one the colour is not that of the table.
    const row = context.getImageData(0, Math.round(canvas.height / 2), canvas.width, 1).data;
    const at = (x: number): string => row.slice(4 * x, 4 * x + 3).join();
    const table = at(canvas.width - 2);
    const isFloor = (x: number): boolean => at(x) !== table;
    let right = canvas.width - 1;
    while (right > 0 && !isFloor(right)) right -= 1;
    let left = Math.round(canvas.width / 2);
    while (left > 0 && isFloor(left)) left -= 1;
    return (right - left) / ratio;
  });

/** Side of a square as large as the robot is painted, in px. */
const robotSide = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const canvas = [...document.querySelectorAll<HTMLCanvasElement>('[data-testid=arena] canvas')].at(-1);
    const context = canvas?.getContext('2d');
    if (!canvas || !context || canvas.width === 0) return 0;
    const ratio = canvas.width / canvas.getBoundingClientRect().width;
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    return Math.round(Math.sqrt(data.filter((alpha, at) => at % 4 === 3 && alpha >= 250).length) / ratio);
  });

/** Buttons and readings that lie outside of what is seen of their pane, or whose words do not fit into them. */
const cutOff = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => {
    const selector = '.app button, .app [role=tab], .app .read, .app .goal, .pane-head h2, .arena-head .name';
    const parts = Array.from(document.querySelectorAll<HTMLElement>(selector));
    const isSeen = (part: HTMLElement): boolean => part.checkVisibility() && part.getBoundingClientRect().width > 1;
    /** True for an element that hides its overflow without a scroll bar or a fade. */
    const clips = (part: Element): boolean => {
      const { overflowX, overflowY } = getComputedStyle(part);
      return [overflowX, overflowY].includes('hidden') || [overflowX, overflowY].includes('clip');
    };
    const found: string[] = [];
    for (const part of parts.filter(isSeen)) {
      if (part.closest('.cm-editor, .vh') !== null) continue;
      const box = part.getBoundingClientRect();
      const name = part.getAttribute('aria-label') ?? part.textContent?.trim().slice(0, 40) ?? '';
      if (box.left < -1 || box.top < -1 || box.right > innerWidth + 1 || box.bottom > innerHeight + 1)
        found.push(`${name}: outside the window`);
      for (let around = part.parentElement; around !== null; around = around.parentElement) {
        if (!clips(around)) continue;
        const frame = around.getBoundingClientRect();
        if (
          box.left < frame.left - 1 ||
          box.right > frame.right + 1 ||
          box.top < frame.top - 1 ||
          box.bottom > frame.bottom + 1
        )
          found.push(`${name}: cut off by .${around.className}`);
      }
    }
    return found;
  });

test.describe('the course comes first', () => {
  for (const [width, height, leastPx] of LEAST_PX)
    for (const language of ['de', 'fr'] as const)
      test(`it is at least ${leastPx} px wide in a window of ${width} × ${height} (${language})`, async ({ page }) => {
        await openAt(page, [width, height], { language });
        await expect.poll(() => courseWidth(page)).toBeGreaterThanOrEqual(leastPx);
        await page.click(on('run'));
        await expect(page.locator(by('verdict'))).toBeVisible();
        expect(await courseWidth(page)).toBeGreaterThanOrEqual(leastPx);
        const distance = await page.locator('.read .figure').first().boundingBox();
        expect(distance?.width, 'a reading with its figure').toBeGreaterThan(20);
      });
});

/** Waits for two pictures, and for what glides or fades to have come to rest. */
const atRest = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const picture = (): Promise<number> => new Promise((done) => requestAnimationFrame(done));
    await picture();
    await picture();
    const ends = document.getAnimations().filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity);
    await Promise.all(ends.map(({ finished }) => finished.catch(() => null)));
    await picture();
  });

/**
 * Goes through all sizes with the page as it is, and looks in each for what is cut off.
 *
 * @param tabs those that are looked at on a phone, which shows one at a time
 */
async function lookInEverySize(page: Page, when: string, tabs: readonly Pane[]): Promise<void> {
  for (const [width, height] of SIZES)
    await test.step(`${when}, ${String(width)} × ${String(height)}`, async () => {
      await page.setViewportSize({ width, height });
      await atRest(page);
      const isPhone = await page.locator('nav.nav').isVisible();
      for (const tab of isPhone ? tabs : [null]) {
        if (tab !== null) await page.locator('nav.nav button').nth(PANES.indexOf(tab)).click();
        await atRest(page);
        expect.soft(await cutOff(page), `${when}, ${String(width)} × ${String(height)}, ${tab ?? 'all'}`).toEqual([]);
        if (when === 'while it drives')
          for (const sensor of await page.locator('.sensor').all()) await expect.soft(sensor).toBeInViewport();
      }
    });
}

test.describe('nothing is cut off in windows of ten sizes', () => {
  for (const language of LANGUAGES)
    test(language, async ({ page }) => {
      await openAt(page, SIZES[0], { language, robot: 'maqueen-plus-v2' });
      await lookInEverySize(page, 'as it opens', PANES);
      await page.setViewportSize({ width: SIZES[0][0], height: SIZES[0][1] });
      await page.click(on('run'));
      await expect(page.locator('.sensor')).toHaveCount(5);
      await lookInEverySize(page, 'while it drives', ['arena']);
      await expect(page.locator(on('stop'))).toBeEnabled();
      await page.click(on('stop'));
      await expect(page.locator('.pane-console .tag')).not.toHaveClass(/tag--run/);
      await lookInEverySize(page, 'after it was stopped', ['console']);
    });
});

for (const [width, height] of [
  [683, 312],
  [844, 390],
] as const)
  test(`a very low window, ${width} by ${height}, has the course, and what comes next beside it`, async ({ page }) => {
    await openAt(page, [width, height], { language: 'de', welcomed: false });
    await expect(page.locator(by('next-step'))).toBeInViewport({ ratio: 1 });
    await page.click(by('welcome-open'));
    await page.click(by('welcome-robot'));
    await page.click(by('task-close'));
    await page.click(on('run'));
    await expect(page.locator(by('step-hint'))).toBeInViewport({ ratio: 1 });
    const floor = await page.locator('.pane-arena .floor').boundingBox();
    expect(floor?.height).toBeGreaterThan(height / 2);
    await page.click(by('mode-lookBack'));
    await expect(page.locator(by('time-rail'))).toBeInViewport();
  });

test('the cinema gives the arena two thirds of the window, and back', async ({ page }) => {
  const share = async (): Promise<number> => ((await page.locator('.pane-arena').boundingBox())?.width ?? 0) / 1366;
  await openAt(page, [1366, 625], { language: 'de' });
  const before = await share();
  const turn = async (): Promise<void> => {
    await page.click(by('show'));
    await page.click(by('cinema'));
  };
  await turn();
  await expect.poll(share).toBeGreaterThan(0.65);
  await turn();
  await expect.poll(share).toBe(before);
});

test('robot and nearest obstacle fill the arena, and the whole arena is shown again', async ({ page }) => {
  await openAt(page, [1366, 768], { language: 'de' });
  await expect.poll(() => robotSide(page)).toBeGreaterThan(0);
  const before = await robotSide(page);
  await page.click(by('show'));
  await page.click(by('near'));
  await expect.poll(() => robotSide(page)).toBeGreaterThan(1.2 * before);
  await page.click(by('show'));
  await page.click(by('fit'));
  await expect.poll(() => robotSide(page)).toBe(before);
});

test('the console is folded while it is empty, and opens for output', async ({ page }) => {
  await openAt(page, [1366, 625], { language: 'de' });
  const heightPx = async (): Promise<number> => (await page.locator('.pane-console').boundingBox())?.height ?? 0;
  expect(await heightPx()).toBeLessThan(60);
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('print("Hallo")\nname = input("Wer? ")\n');
  await page.click(on('run'));
  await expect.poll(heightPx).toBeGreaterThan(120);
  await expect(page.locator(by('console-input'))).toBeFocused();
});

test('on a phone Run turns to the arena, and to the console when the program asks', async ({ page }) => {
  await openAt(page, [390, 844], { language: 'de' });
  await page.click(on('run'));
  await expect(page.locator('.pane-arena')).toBeVisible();
  await page.click(on('stop'));
  await page.locator('nav.nav button').nth(0).click();
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('name = input("Wer? ")\n');
  await page.click(on('run'));
  await expect(page.locator(by('console-input'))).toBeVisible();
});
