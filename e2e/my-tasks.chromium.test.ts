import { readFileSync } from 'node:fs';

import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { by } from './parts';

test.use({ locale: 'de-CH' });

const scene = JSON.parse(readFileSync('courses/closed-line/scene.json', 'utf8')) as object;
const task = { version: 1, checks: [{ type: 'goals', id: 'goals' }], about: { level: 'Klasse 8', author: 'Ada' } };
const project = { format: 'parcours-project', version: 4, files: [{ name: 'main.py', text: 'forward()\n' }], task };
const file = (name: string) => ({
  ...{ name: `${name}.json`, mimeType: 'application/json' },
  buffer: Buffer.from(JSON.stringify({ ...project, scene: { ...scene, name } })),
});

test('tasks of two tabs lie on one shelf, are there after a reload, and come back when deleted; axe finds nothing', async ({
  page,
}) => {
  const rows = page.locator(by('tasks-row'));
  await page.goto('./#tasks');
  await page.setInputFiles(by('tasks-picker'), [file('Linie'), file('Wand')]);
  await expect(rows).toHaveText([/Linie.*Klasse 8 · Ada/, /Wand/]);
  const other = await page.context().newPage();
  await other.goto('./#tasks');
  await other.setInputFiles(by('tasks-picker'), [file('Slalom')]);
  await expect(other.locator(by('tasks-row'))).toHaveCount(3);
  await other.close();
  await page.setInputFiles(by('tasks-picker'), [file('Turm')]);
  await expect(rows).toHaveCount(4);
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  await page.reload();
  await expect(rows).toHaveText([/Turm/, /Slalom/, /Linie/, /Wand/]);
  await page.fill(by('tasks-search'), 'turm');
  await page.click(by('tasks-more'));
  await page.click(by('tasks-remove'));
  await expect(rows).toHaveCount(0);
  await page.locator('.notice').getByRole('button').first().click();
  await expect(rows).toHaveText([/Turm/]);
  await page.click(by('tasks-open'));
  await expect(page.locator(by('maker'))).toBeVisible();
  await page.click(by('maker-menu'));
  await page.click(by('maker-keep'));
  await expect(page.locator('.notice')).toContainText('«Turm» ist in «Meine Aufgaben» erneuert.');
});
