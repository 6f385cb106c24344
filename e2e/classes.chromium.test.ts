import { readFileSync } from 'node:fs';

import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { by } from './parts';

test.use({ locale: 'de-CH' });

const FILE = readFileSync(new URL('../src/school-class/kept/v1.json', import.meta.url));

test('a class is opened, kept on request, and is there again after a reload; axe finds nothing', async ({ page }) => {
  await page.goto('./#classes');
  await page.setInputFiles(by('classes-file'), { name: '8b.json', mimeType: 'application/json', buffer: FILE });
  const rows = page.locator(`${by('classes-table')} tbody tr`);
  await expect(rows).toHaveCount(3);
  await expect(rows.first()).toContainText('4/4');
  await page.click(by('classes-more'));
  await page.click(by('classes-keep'));
  await page.click(by('classes-task'));
  await page.fill(by('class-task-due'), '2126-12-04');
  await page.click(by('class-dialog-done'));
  await expect(page.locator(by('classes-table'))).toContainText('bis 04.12.2126');
  await expect(rows.nth(2)).toContainText('offen');
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  await expect(async () => {
    await page.reload();
    await expect(page.locator(by('classes-table'))).toContainText('bis 04.12.2126', { timeout: 2000 });
  }).toPass();
  await page.click(by('classes-more'));
  await page.click(by('classes-remove'));
  await expect(page.locator(by('classes-none'))).toBeVisible();
  await page.locator('.notice').getByRole('button').first().click();
  await expect(rows).toHaveCount(3);
});
