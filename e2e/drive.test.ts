import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { consoleIn, on, openApp, robotIn, typeProgram } from './page';

test('a typed program drives the robot and prints in the console', async ({ app }) => {
  await openApp(app);
  const before = await robotIn(app);
  await typeProgram(
    app,
    ['from mbrobot import *', 'print("off we go")', 'forward()', 'delay(2000)', 'stop()'].join('\n'),
  );
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('off we go');
  await expect.poll(async () => (await robotIn(app)).xMm - before.xMm).toBeGreaterThan(100);
  const after = await robotIn(app);
  expect(Math.abs(after.yMm - before.yMm)).toBeLessThan(2);
});

test('reset puts the robot back to where the course has it', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  const before = await robotIn(app);
  await typeProgram(app, 'from mbrobot import *\nforward()');
  await app.click(on('run'));
  await expect.poll(async () => (await robotIn(app)).xMm - before.xMm).toBeGreaterThan(50);
  await app.click(on('reset'));
  await expect.poll(() => robotIn(app)).toEqual(before);
});

test('an exception names the file and the line', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await typeProgram(app, 'speed = 50\nprint(sped)');
  await app.click(on('run'));
  // All at once: while lines come, the list is made anew.
  await expect.poll(() => consoleIn(app)).toMatch(/main\.py[^]*line 2[^]*NameError/);
});
