import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { consoleIn, isEnabled, on, openApp, pasteProgram } from './page';
import { by, until } from './parts';

const FIELD = '[data-testid=console-input]';

const says = (app: App, text: RegExp | string): Promise<void> =>
  typeof text === 'string'
    ? expect.poll(() => consoleIn(app)).toContain(text)
    : expect.poll(() => consoleIn(app)).toMatch(text);

async function start(app: App, source: string): Promise<void> {
  await openApp(app, { language: 'en' });
  await pasteProgram(app, source);
  await app.click(on('run'));
}

/** Goes to the REPL: what a program prints leaves the console folded. */
async function toField(app: App): Promise<void> {
  await app.click(by('console-fold'));
  await app.click(FIELD);
}

/** Types one line and sends it. */
async function line(app: App, text: string): Promise<void> {
  if (text !== '') await app.type(text);
  await app.press('Enter');
}

test(
  'after the program the REPL greets as the device does, calculates, and shows an error',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await start(app, 'total = 20\nprint("end")');
    await until(app, 'button.stop.over');
    expect(await consoleIn(app), 'until one goes to it').not.toContain('>>>');
    await toField(app);
    await says(app, /end\s[^]*MicroPython v1\.18 on .*micro:bit v2\.1\.2 with nRF52833\s+Type "help\(\)"[^\n]*\s+>>>/);
    await line(app, 'total * 2 + 2');
    await says(app, /\+ 2\s+42\s+>>>/);
    await line(app, 'totl');
    await says(app, /File "<stdin>", line 1, in <module>\s+NameError: name 'totl' (is not|isn't) defined[^]*>>>/);
  },
);

test('a function of several lines is written at the REPL and called', IN_ONE_ENGINE, async ({ app }) => {
  await start(app, 'print("end")');
  await until(app, 'button.stop.over');
  await toField(app);
  await says(app, '>>>');
  await line(app, 'def twice(x):');
  await line(app, 'y = x + x');
  await line(app, 'return y'); // the field keeps the indentation of the block by itself
  await line(app, ''); // the first of the two takes the indentation away, the second ends the block
  await line(app, '');
  await line(app, 'twice(21)');
  await says(app, /twice\(21\)\s+42\s+>>>/);
});

const ENDLESS = 'n = 0\nprint("begin")\nwhile True:\n    n = n + 1';

test('Ctrl-C ends a loop without end, and its variable can be looked at', async ({ app }) => {
  await start(app, ENDLESS);
  await says(app, 'begin');
  await toField(app);
  await app.press('Control', 'c');
  await says(app, /KeyboardInterrupt[^]*>>>/);
  await line(app, 'n > 0');
  await says(app, /n > 0\s+True\s+>>>/);
});

test('Ctrl-D begins the program anew, and Ctrl-C ends it again', IN_ONE_ENGINE, async ({ app }) => {
  await start(app, ENDLESS);
  await says(app, 'begin');
  await toField(app);
  await app.press('Control', 'd'); // interrupts first: only the REPL takes it
  await says(app, /KeyboardInterrupt[^]*MPY: soft reboot\s+begin/);
  expect(await isEnabled(app, 'stop')).toBe(true);
  await app.press('Control', 'c');
  await says(app, /soft reboot[^]*KeyboardInterrupt[^]*>>>/);
});
