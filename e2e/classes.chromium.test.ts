import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import type { Page } from '@playwright/test';

import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { CREEP, RIGHT } from './class-page';
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

/** Three weeks of a class: the day, the task, and what was handed in. */
const WEEKS = [
  { day: '2026-11-02', task: 'closed-line', handIns: { 'Ada Meier': RIGHT, 'Ben Huber': 'x = 1\n' } },
  { day: '2026-11-09', task: 'closed-line', handIns: { 'Ben Huber': RIGHT, 'Zoe': CREEP } },
  { day: '2026-11-16', task: 'slalom', handIns: { 'Ada Meier': CREEP } },
] as const; // prettier-ignore

/** The file of the class as the command line writes it. */
function writtenByCommandLine(folder: string): string {
  const file = join(folder, '8b.json');
  const list = join(folder, 'names.txt');
  const parcours = (...words: string[]): unknown =>
    execFileSync('node', ['bin/parcours.mjs', 'class', ...words, '--lang', 'de']);
  writeFileSync(list, 'Ada Meier\nBen Huber\n');
  parcours('set', file, '--name', 'Klasse 8b', '--names', list, '--scale', 'ch6');
  for (const { day, task, handIns } of WEEKS) {
    const inside = join(folder, day);
    mkdirSync(inside);
    for (const [name, text] of Object.entries(handIns)) writeFileSync(join(inside, `${name}.py`), text);
    parcours('add', file, task, inside, '--date', day);
  }
  return readFileSync(file, 'utf8');
}

/** True if the browser's database has a text somewhere. */
const isStored = (page: Page, text: string): Promise<boolean> =>
  page.evaluate(async (wanted) => {
    const done = <T>(request: IDBRequest<T>): Promise<T> =>
      new Promise((resolve) => request.addEventListener('success', () => resolve(request.result)));
    for (const { name = '' } of await indexedDB.databases()) {
      const database = await done(indexedDB.open(name));
      for (const store of database.objectStoreNames)
        if (JSON.stringify(await done(database.transaction(store).objectStore(store).getAll())).includes(wanted))
          return true;
    }
    return false;
  }, text);

test('three weeks of a class give the same file as by the command line', async ({ page }, { outputDir }) => {
  page.on('dialog', (dialog) => void dialog.accept());
  await page.clock.setFixedTime(`${WEEKS[0].day}T10:00:00`);
  await page.goto('./#classes');
  await page.click(by('classes-begin'));
  await page.fill(by('class-name'), 'Klasse 8b');
  await page.fill(by('class-names'), 'Ada Meier\nBen Huber');
  await page.selectOption(by('class-scale'), 'ch6');
  await page.click(by('class-dialog-done'));
  await page.click(by('classes-more'));
  await page.click(by('classes-keep'));
  for (const { day, task, handIns } of WEEKS) {
    await page.clock.setFixedTime(`${day}T10:00:00`);
    await page.goto('./#class');
    await page.reload();
    await page.selectOption(by('class-task'), task);
    const files = Object.entries(handIns).map(([name, text]) => ({ name: `${name}.py`, mimeType: 'text/x-python', buffer: Buffer.from(text) })); // prettier-ignore
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click(by('class-files'))]);
    await chooser.setFiles(files);
    await page.goto('./#classes');
    await page.click(by('classes-enter'), { timeout: 60_000 });
    await expect(page.locator(by('classes-checked'))).toBeHidden();
    await expect.poll(() => isStored(page, day)).toBe(true);
  }
  await page.click(by('classes-more'));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(by('classes-save'))]);
  mkdirSync(outputDir, { recursive: true });
  expect(readFileSync(await download.path(), 'utf8')).toBe(writtenByCommandLine(outputDir));
});
