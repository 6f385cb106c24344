import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { by } from './parts';

test.use({ locale: 'de-CH' });

test('the handbook is found on the page for teachers, searched, read and left for what it is about', async ({
  page,
}) => {
  await page.goto('./#teachers');
  await page.fill(by('desk-search'), 'verborgene Welten');
  await page.click(by('found-desk-handbook-task.worlds'));
  await expect(page.locator(by('handbook-heading'))).toHaveText('Welten: dieselbe Aufgabe, anderer Start');
  expect(page.url()).toContain('#handbook/task.worlds');
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);

  await page.fill(by('handbook-search'), 'Tabelle lesen');
  await page.click(by('found-check'));
  await expect(page.locator(by('chapter-check'))).toHaveAttribute('aria-current', 'page');
  await page.click(by('handbook-show'));
  await page.waitForSelector(by('class-adding'));
  await page.goBack();
  await expect(page.locator(by('handbook-heading'))).toHaveText('Die Tabelle lesen');
  await page.selectOption(by('handbook-language'), 'fr');
  await expect(page.locator(by('handbook-heading'))).toHaveText('Lire le tableau');
});

test('the sheet on data protection is printed on two pages of A4 at most, without anything of the page around it', async ({
  page,
}) => {
  await page.goto('./#handbook/data-protection');
  await page.waitForSelector(by('data-protection'));
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  for (const language of ['de', 'fr', 'it', 'en']) {
    await page.selectOption(by('handbook-language'), language);
    await page.waitForTimeout(300);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    expect(pdf.match(/\/Type\s*\/Page\b/g)?.length, language).toBeLessThanOrEqual(2);
  }
});
