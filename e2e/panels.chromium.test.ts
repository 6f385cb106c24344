import { AxeBuilder } from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { on } from './page';

for (const colorScheme of ['light', 'dark'] as const) {
  for (const panel of ['sensors', 'radio', 'log']) {
    test(`axe finds nothing that shuts people out of the open panel ${panel}, ${colorScheme}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.goto('./');
      await page.click(`[data-testid=panel-${panel}]`);
      await expect(page.locator('.panel-open button').first()).toBeVisible();
      await page.click(on('run'));
      for (const fold of await page.locator('.panel-open summary').all()) await fold.click();
      // axe's types come with a copy of Playwright's of their own.
      const { violations } = await new AxeBuilder({ page: page as never }).analyze();
      const told = violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`,
      );
      expect(told).toEqual([]);
    });
  }
}

test('a thousand rows of the data log are a few dozen lines on the page, and all of them in the file', async ({
  page,
}) => {
  await page.goto('./');
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('import log\nfor i in range(1000): log.add(n=i)\nprint("done")\n');
  await page.click('[data-testid=panel-log]');
  await page.click(on('run'));
  await expect(page.locator(on('console'))).toContainText('done');
  await expect(page.locator('.panel-open .tag')).toContainText('1000');
  expect(await page.locator('.panel-open tr.data').count()).toBeLessThan(60);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('.panel-open [aria-label*="CSV"]')]);
  const stream = await download.createReadStream();
  let text = '';
  for await (const chunk of stream) text += String(chunk);
  expect(text.trimEnd().split('\r\n')).toHaveLength(1001);
});
