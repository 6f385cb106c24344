import { expect, test } from './app';
import { openApp, programIn, typeProgram } from './page';

test('a reload keeps the program', async ({ app }) => {
  const source = 'print("kept")\nx = 1';
  await openApp(app);
  await typeProgram(app, source);
  await app.reload();
  await expect.poll(() => programIn(app)).toBe(source);
});
