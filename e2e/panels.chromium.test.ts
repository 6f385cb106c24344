import { expect, playwrightApp, warmTest as test } from './app';
import { on } from './page';
import { openPanel } from './parts';

test('a thousand rows of the data log are a few dozen lines on the page, and all of them in the file', async ({
  page,
}) => {
  await page.goto('./');
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('import log\nfor i in range(1000): log.add(n=i)\nprint("done")\n');
  await openPanel(playwrightApp('chromium', page), 'log');
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
