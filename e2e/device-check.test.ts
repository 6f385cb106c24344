import { expect, test } from './app';
import { openApp, typeProgram } from './page';

const PANEL = '[data-testid=device-check]';
const MARK = '.cm-deviceMark';

test('what does not run on the device is marked, explained in its line, and no longer once it is mended', async ({
  app,
}) => {
  await openApp(app);
  const has = (css: string) => app.evaluate((selector) => document.querySelector(selector) !== null, css);
  await typeProgram(app, 'x = 3\nprint(f"{x}")');
  await expect.poll(() => has(MARK), { timeout: 10_000 }).toBe(true);
  expect(await app.text(PANEL)).toContain('"{}".format(x)');

  await app.press('ArrowUp');
  await expect.poll(() => app.text(PANEL)).not.toContain('format');
  await app.press('F8');
  await expect.poll(() => app.text(PANEL)).toContain('"{}".format(x)');

  await typeProgram(app, 'x = 3\nprint("{}".format(x))');
  await expect.poll(() => has(PANEL)).toBe(false);
});
