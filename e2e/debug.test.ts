import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { openedCourse } from './opened-course';
import { consoleIn, on, openApp, openWork, pasteProgram, robotIn } from './page';
import { by, gone, until } from './parts';
import { tablet, withFingers } from './touch';

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
const line = (count: number): string => `.cm-content .cm-line:nth-child(${count})`;
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

test(
  'the line where the program stands is in sight, though the bar for steps takes room below it',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(app, `${'# far down\n'.repeat(40)}from mbrobot import *\nwhile True:\n    delay(50)`);
    await app.click(on('run'));
    await until(app, by('mode-lookBack'));
    await app.click(by('mode-lookBack'));
    await until(app, by('step-bar'));
    const isInSight = (): Promise<boolean> =>
      app.evaluate(() => {
        const { bottom = Infinity } = document.querySelector('.cm-standingLine')?.getBoundingClientRect() ?? {};
        return bottom <= (document.querySelector('.cm-scroller')?.getBoundingClientRect().bottom ?? 0);
      });
    await expect.poll(isInSight).toBe(true);
  },
);

test(
  'an error is looked into: its line with the variables of then, line by line back and on again',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(app, FAILING);
    await app.click(on('run'));
    await until(app, by('error-raw'));
    await app.click(by('error-raw'));
    await app.click(by('error-look'));
    await expect.poll(() => at(app)).toMatch(/ 4$/);
    await expect.poll(() => variables(app)).toEqual(expect.arrayContaining(['a int 1', 'rest int 0', 'n int 1']));
    await app.click(by('step-back'));
    await expect.poll(() => at(app)).toMatch(/ 3$/);
    await app.click(by('step-back'));
    await expect.poll(() => at(app)).toMatch(/ 9$/);
    await app.click(by('step-into'));
    await expect.poll(() => at(app)).toMatch(/ 3$/);
    await app.click(by('mode-drive'));
    await gone(app, by('step-bar'));
  },
);

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

/** A robot, and a board without one beside it, each with a program of its own. */
function pair(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: object };
  const files = [{ name: 'main.py', text: ROBOT }];
  const hardware = { device: 'auto', firmware: '', robot: 'none', robotOptions: {} };
  const board = { ...hardware, name: 'Board', files: [{ name: 'main.py', text: BOARD }], sameAs: '' };
  return JSON.stringify({ ...work, project: { ...work.project, files, devices: { first: 'Robot', others: [board] } } });
}
const ROBOT = `from mbrobot import *
n = 1
forward()
while True:
    n = n + 1
    delay(100)
`;
const BOARD = `from microbit import *
word = "a"
while True:
    sleep(150)
    word = word + "b"
`;
/** How far the first device has counted: it does so every 100 ms of simulated time. */
async function countOfFirst(app: App): Promise<number> {
  await app.click(card(0));
  const count = async () => Number(/^n int (\d+)/m.exec((await variables(app)).join('\n'))?.[1]);
  await expect.poll(count).toBeGreaterThan(0);
  return count();
}
const card = (place: number): string => `.device-row .card:nth-child(${String(place + 1)}) .select`;

test(
  'of several devices all stand at the break point of one, and each is stepped as it is chosen',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openWork(app, pair());
    await until(app, card(1));
    await app.click(card(1));
    await expect.poll(() => app.text('.cm-content')).toContain('word');
    await app.click(number(5));
    await app.click(card(0));
    await app.click(on('run'));
    await expect.poll(() => at(app)).toMatch(/ 5$/); // that of the board, which comes into sight
    await expect.poll(() => variables(app)).toContain("word str 'a'");
    const count = await countOfFirst(app);
    await app.click(card(1));
    await expect.poll(() => at(app)).toMatch(/ 5$/);
    await app.click(by('step-over'));
    await expect.poll(() => at(app)).toMatch(/ 4$/);
    await expect.poll(() => variables(app)).toContainEqual(expect.stringContaining("word str 'ab'"));
    expect(await countOfFirst(app)).toEqual(count); // no time goes by for adding two words
    await app.click(card(1));
    await expect.poll(() => at(app)).toMatch(/ 4$/);
    await app.click(by('step-over'));
    await app.click(by('step-over'));
    await expect.poll(() => countOfFirst(app)).toBeGreaterThan(count);
  },
);

test.describe('with fingers on a tablet', () => {
  test.use(tablet);
  test(
    'a break point is set, and a tap on a name shows its value until the next step',
    IN_ONE_ENGINE,
    async ({ page }) => {
      const { app, fingers } = await withFingers(page);
      await openWork(app, openedCourse('empty'));
      await until(app, on('editor'));
      await pasteProgram(app, PROGRAM);
      await fingers.tap(number(8));
      await fingers.tap(on('run'));
      await expect.poll(() => at(app)).toMatch(/ 8$/);
      await fingers.tap(line(6));
      await gone(app, by('value-card')); // beside the line's end there is no name
      const name = await page.locator(line(6)).evaluate((element) => {
        const { left, top, height } = element.getBoundingClientRect();
        return { x: left + 8, y: top + height / 2 };
      });
      await fingers.tapAt(name);
      await expect.poll(() => app.text(by('value-card'))).toBe('n int 1');
      await fingers.tap(by('step-over'));
      await gone(app, by('value-card'));
    },
  );
});

test(
  'the first line back after a step moves, and forwards the present comes back and goes on',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(app, 'n = 0\nwhile True:\n    n += 1\n    a = n\n    b = a\n    c = b\n');
    await app.click(number(4));
    await app.click(on('run'));
    await expect.poll(() => at(app)).toMatch(/\b4\b/);
    await app.click(by('step-over'));
    await expect.poll(() => at(app)).toMatch(/\b5\b/);
    await app.click(by('step-back'));
    await until(app, by('time-rail'));
    await expect.poll(() => at(app)).toMatch(/\b4\b/);
    await app.click(by('step-over'));
    await gone(app, by('time-rail')); // the recording ends here
    await expect.poll(() => at(app)).toMatch(/\b5\b/);
    await app.click(by('step-over'));
    await expect.poll(() => at(app)).toMatch(/\b6\b/);
  },
);
