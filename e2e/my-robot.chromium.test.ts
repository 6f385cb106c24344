import { expect, test } from './app';
import { violationsOn } from './axe';
import { consoleIn, on, openApp, pasteProgram } from './page';
import { until } from './parts';

const PROGRAM = 'from mbrobot import *\nforward()\ndelay(2000)\nstop()\nprint("done")\n';

test('a robot is measured, the simulated one is fitted to it and still drives for it when the page is loaded anew', async ({
  app,
}) => {
  await openApp(app, { welcomed: true, language: 'de', robot: 'maqueen-lite' });
  await app.click('[data-testid=device]');
  await app.click('[data-testid=my-robot]');
  await until(app, '[data-testid=drive-usual]');
  expect(await violationsOn(app), 'before anything is measured').toEqual([]);
  await app.fill('[data-testid=drive-usual] .field:nth-of-type(1) input', '34.6');
  await app.fill('[data-testid=drive-usual] .field:nth-of-type(2) input', '6.4');
  await app.click('[data-testid=drive-usual] .sides button:nth-of-type(2)');
  await until(app, '[data-testid=fit-after]');
  await expect.poll(() => app.text('[data-testid=fit-traits]')).toContain('105 %');
  expect(await violationsOn(app), 'with the fit').toEqual([]);
  await app.click('[data-testid=my-robot-use]');
  await app.click('[data-testid=gallery-close]');

  await app.reload();
  await until(app, on('editor'));
  await pasteProgram(app, PROGRAM);
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain('done');
  await app.click('[data-testid=device]');
  await until(app, '[data-testid=my-robot-used]');
  expect(
    await app.evaluate(() => document.querySelector<HTMLInputElement>('[data-testid=my-robot-used]')?.checked),
  ).toBe(true);
});
