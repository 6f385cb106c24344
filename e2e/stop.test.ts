import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { isEnabled, on, openApp, typeProgram } from './page';

/** Programs that never end by themselves, and where they run: a busy worker ends in every engine, whatever keeps it busy. */
const ENDLESS = [
  ['a loop that does nothing', IN_ONE_ENGINE, 'while True: pass'],
  ['a loop that prints', {}, 'while True: print(1)'],
  ['a loop that catches everything', IN_ONE_ENGINE, 'while True:\n    try:\n        x = 1\n    except:\n        pass'],
  ['one long call inside the interpreter', {}, 'sum(range(10**9))'],
] as const;

for (const [name, engines, source] of ENDLESS) {
  test(`stop ends ${name}, and the next program runs`, engines, async ({ app }) => {
    await openApp(app);
    await typeProgram(app, source);
    await app.click(on('run'));
    await expect.poll(() => isEnabled(app, 'stop')).toBe(true);
    await app.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
    await app.click(on('stop'));
    await expect.poll(() => isEnabled(app, 'stop'), { timeout: 5_000 }).toBe(false);

    await typeProgram(app, 'print("still here")');
    await app.click(on('run'));
    await expect.poll(() => app.text(on('console'))).toContain('still here');
  });
}
