import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { on, openApp, pasteProgram } from './page';
import { by, until } from './parts';

const PROGRAM = `from mbrobot import *
setSpeed(30)
forward()
for n in range(1000):
    print("number:", n)
    delay(100)
`;
const valueText = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="chart-plot"]')?.getAttribute('aria-valuetext') ?? '');
const timeMs = async (app: App): Promise<number> =>
  Number(await app.evaluate(() => document.querySelector('[data-testid="time-rail"]')?.getAttribute('aria-valuenow')));

test(
  'printed numbers are drawn live, and the chart and the time line go to the same moment',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(app, PROGRAM);
    await app.click(on('run'));
    await app.click(by('console-fold'));
    await app.click(by('tab-chart'));
    await until(app, by('chart-plot'));
    await expect.poll(() => valueText(app)).toMatch(/number \d{2,}$/);
    expect(await violationsOn(app)).toEqual([]);
    await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="chart-plot"]')?.focus());
    await app.press('Home');
    await expect.poll(() => timeMs(app)).toBe(0);
    await app.press('PageUp');
    await expect.poll(() => timeMs(app)).toBe(1000);
    await expect.poll(() => valueText(app)).toMatch(/^00:01\.00, number [89]$/);
    await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
    await app.press('ArrowLeft');
    await expect.poll(() => valueText(app)).toContain('00:00.98');
  },
);
