import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { consoleIn, on, openApp, pasteProgram, robotIn } from './page';
import { by, gone, until } from './parts';

const PROGRAM = `from mbrobot import *
def twice(a):
    b = 2 * a
    return b
forward()
n = 1
while n < 100:
    n = twice(n)
    delay(100)
print("n is", n)
`;
const FAILING = `from mbrobot import *
def part(a):
    rest = a - 1
    return 100 / rest
n = 3
forward()
while True:
    delay(200)
    print(part(n))
    n -= 1
`;
/** The number of a line; the first of its column measures the width only. */
const number = (line: number): string => `.cm-lineNumbers .cm-gutterElement:nth-child(${line + 1})`;
const at = (app: App): Promise<string> => app.text(by('step-at'));
/** The variables that are shown: `n int 4`. */
const variables = (app: App): Promise<string[]> =>
  app.evaluate(() =>
    Array.from(document.querySelectorAll('[data-testid="variable"] .row'), (row) =>
      Array.from(row.children, ({ textContent }) => (textContent ?? '').trim())
        .filter((text) => text !== '')
        .join(' '),
    ),
  );

test('a break point stops the program and all time; line by line it goes on, and tells its variables', async ({
  app,
}) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM);
  await app.click(number(9));
  await until(app, '.cm-deviceGutter .cm-breakPoint');
  await app.click(on('run'));
  await until(app, by('step-bar'));
  await expect.poll(() => at(app)).toMatch(/ 9$/);
  await expect.poll(() => variables(app)).toContain('n int 2');
  const stood = await robotIn(app);
  await app.click(by('step-over'));
  await expect.poll(() => at(app)).toMatch(/ 7$/);
  await expect.poll(async () => (await robotIn(app)).xMm).toBeGreaterThan(stood.xMm);
  await app.click(by('step-over'));
  await expect.poll(() => at(app)).toMatch(/ 8$/);
  await app.click(by('step-into'));
  await expect.poll(() => at(app)).toMatch(/ 3$/);
  await expect.poll(() => variables(app)).toContain('a int 2');
  await app.click(by('step-out'));
  await expect.poll(() => at(app)).toMatch(/ 8$/);
  await app.click(number(9)); // taken away: the program runs to its end
  await gone(app, '.cm-deviceGutter .cm-breakPoint');
  await app.click(by('step-on'));
  await gone(app, by('step-bar'));
  await expect.poll(() => consoleIn(app)).toContain('n is 128');
});

test('an error is looked into: its line with the variables of then, line by line back and on again', async ({
  app,
}) => {
  await openApp(app);
  await pasteProgram(app, FAILING);
  await app.click(on('run'));
  await until(app, by('error-look'));
  await app.click(by('error-look'));
  await expect.poll(() => at(app)).toMatch(/ 4$/);
  await expect.poll(() => variables(app)).toEqual(expect.arrayContaining(['a int 1', 'rest int 0', 'n int 1']));
  await app.click(by('step-back'));
  await expect.poll(() => at(app)).toMatch(/ 3$/);
  await app.click(by('step-back'));
  await expect.poll(() => at(app)).toMatch(/ 9$/);
  await app.click(by('step-into'));
  await expect.poll(() => at(app)).toMatch(/ 3$/);
  await app.click(by('look-back-close'));
  await gone(app, by('step-bar'));
});

test(
  'by keyboard: F9 sets a break point, which a reload keeps, F10 and F8 lead on; nothing bars a screen reader',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(app, PROGRAM);
    await app.press('ArrowUp', 'ArrowUp', 'F9'); // line 9
    await until(app, '.cm-deviceGutter .cm-breakPoint');
    await app.reload();
    await until(app, '.cm-deviceGutter .cm-breakPoint');
    await app.click(on('run'));
    await until(app, by('variables'));
    await expect.poll(() => variables(app)).toContain('n int 2');
    expect(await violationsOn(app)).toEqual([]);
    await app.press('F10');
    await expect.poll(() => at(app)).toMatch(/ 7$/);
    await app.press('F8');
    await expect.poll(() => at(app)).toMatch(/ 9$/);
    await expect.poll(() => variables(app)).toContainEqual(expect.stringMatching(/^n int 4/));
    await app.click(by('tab-board'));
    await gone(app, by('variables'));
  },
);
