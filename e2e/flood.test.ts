import { expect, test } from './app';
import { consoleIn, isEnabled, isThere, on, openApp, pasteProgram, programIn } from './page';

/** Longest the page may leave an answer open while it is flooded, in ms; chosen: beyond it a pupil clicks again. */
const ANSWER_MS = 1500;

test('a million printed lines leave the page responsive: meanwhile a panel opens and text is written', async ({
  app,
}) => {
  await openApp(app, { speed: 'max' });
  await pasteProgram(app, 'for i in range(2000): print("line\\n" * 499 + str(i))\nprint("all")');
  await app.click(on('run'));
  await expect.poll(() => isEnabled(app, 'stop')).toBe(true);
  await expect.poll(() => consoleIn(app)).toContain('line');

  await app.click('[data-testid=panel-radio]');
  await expect.poll(() => isThere(app, '.panel-open input'), { timeout: ANSWER_MS }).toBe(true);
  await app.click(on('editor'));
  await app.press('Control', 'End');
  await app.type('# still there');
  await expect.poll(() => programIn(app), { timeout: ANSWER_MS }).toContain('# still there');

  await expect.poll(() => consoleIn(app), { timeout: 60_000 }).toMatch(/1999\s+all/);
  expect(await app.evaluate((css) => document.querySelectorAll(`${css} *`).length, on('console'))).toBeLessThan(6000);
});
