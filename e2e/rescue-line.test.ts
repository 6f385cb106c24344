import { demoMap } from '../src/rescue-line/testing/maps';
import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { enterMode, on, openApp } from './page';
import { by, until } from './parts';
import { dropFile } from './transfer';

test.use({ viewport: { width: 1366, height: 768 } });

const MAP = { name: 'map.json', text: JSON.stringify(demoMap()) };

test(
  'a map of RoboCup Junior opens with its score sheet and its points on the tiles; a lack of progress begins a new try',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await dropFile(app, MAP);
    await until(app, by('task-score'));
    await until(app, by('league-marks'));
    expect(await app.text(by('score-sum'))).toContain('5');
    await app.click(on('run'));
    await until(app, by('no-progress'));
    expect(await app.text(by('referee'))).toContain('Try 1');
    await app.click(by('no-progress'));
    await expect.poll(() => app.text(by('referee'))).toContain('Try 2');
  },
);

test('a line is built from tiles, one after the other, and scored by the rules that are chosen', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'en' });
  await enterMode(app, 'build');
  await app.click(by('course-more'));
  await app.click(by('editor-line'));
  for (const tile of ['straight', 'obstacle']) await app.click(by(`line-${tile}`));
  await expect.poll(() => app.text(by('line-most'))).toContain('2 tiles, at most');
  const before = await app.text(by('line-most'));
  await app.click(by('line-rules-line-entry-2026'));
  await expect.poll(() => app.text(by('line-most'))).not.toBe(before);
}); // prettier-ignore
