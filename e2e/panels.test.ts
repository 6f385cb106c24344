import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { consoleIn, isThere, on, openApp, pasteProgram, typeProgram } from './page';
import { by, openPanel, until } from './parts';

test(
  'a sensor set before the run is felt by the program, and one moved meanwhile too',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await typeProgram(
      app,
      'from microbit import *\nwhile True:\n    print("light", display.read_light_level())\n    sleep(100)',
    );
    await openPanel(app, 'sensors');
    const slider = '.panel-open input[type=range]';
    await expect.poll(() => isThere(app, slider)).toBe(true);
    await app.click(slider);
    await app.press('End');
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('light 255');
    await app.click(slider);
    await app.press('Home');
    await expect.poll(() => consoleIn(app)).toMatch(/light 0\s*$/);
  },
);

test(
  'after the program’s end its names can be asked for, line by line and with arrow up',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await typeProgram(app, 'n = 20\nprint("end")');
    await app.click(on('run'));
    await until(app, 'button.stop.over');
    const field = '[data-testid=console-input]';
    await app.click(by('console-fold'));
    await app.click(field);
    await expect.poll(() => app.text('.pane-console .pane-head')).toContain('REPL');
    await app.type('n = n + 1');
    await app.press('Enter');
    await app.press('ArrowUp');
    await app.press('Enter');
    await app.type('print(n * 2)');
    await app.press('Enter');
    await expect.poll(() => consoleIn(app)).toMatch(/>>> print\(n \* 2\)\s+44\s+>>>/);
  },
);

test('messages go over the air both ways', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  const program =
    'import radio\nradio.on()\nradio.send("ready")\nwhile True:\n    m = radio.receive()\n    if m: print("got", m)';
  await typeProgram(app, program);
  await openPanel(app, 'radio');
  await app.click(on('run'));
  await expect.poll(() => isThere(app, '.panel-open li')).toBe(true);
  expect(await app.text('.panel-open ol')).toContain('ready');
  await app.fill('.panel-open input', 'hello board');
  await app.press('Enter');
  await expect.poll(() => consoleIn(app)).toContain('got hello board');
});

test(
  'what a program logs is a row in the table, and all of it in the file that is saved',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await pasteProgram(
      app,
      'import log\nlog.set_labels(timestamp=None)\nlog.add(light=12, temp=20.5)\nlog.add(light=13)',
    );
    await openPanel(app, 'log');
    await app.click(on('run'));
    await expect.poll(() => isThere(app, '.panel-open tr.data + tr.data')).toBe(true);
    expect(await app.text('.panel-open table')).toMatch(/light.*temp.*12.*20\.5.*13/s);
    // Of a download WebKitGTK and Firefox tell nobody: the page itself is asked what it hands over.
    const saved = await app.evaluate(async () => {
      const handed: { blob?: Blob; name?: string } = {};
      const addressOf = URL.createObjectURL.bind(URL);
      URL.createObjectURL = (blob: Blob) => addressOf((handed.blob = blob));
      HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
        handed.name = this.download;
      };
      document.querySelector<HTMLButtonElement>('.panel-open [aria-label*="CSV"]')?.click();
      return { name: handed.name, text: await handed.blob?.text() };
    });
    expect(saved.name).toBe('data-log.csv');
    expect(saved.text?.trimEnd().split('\r\n')).toEqual(['light,temp', '12,20.5', '13,']);
  },
);
