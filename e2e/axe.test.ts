import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { consoleIn, isThere, on, openApp, pasteProgram } from './page';

/** It fills the radio panel, the data log and the console, and ends with an error. */
const PROGRAM = ['import radio, log', 'radio.on()', 'radio.send("hello")', 'log.add(n=1)', 'print(nn)'];

const until = (app: App, css: string): Promise<void> => expect.poll(() => isThere(app, css)).toBe(true);

/** Runs the program on a board; afterwards the error is explained in the console, and the REPL waits. */
async function runOn(app: App, module: string): Promise<void> {
  await pasteProgram(app, [`from ${module} import *`, ...PROGRAM].join('\n'));
  await app.click(on('run'));
  await until(app, '[role=log] .card');
  await app.click('[data-testid=interrupt]'); // the board shows its error by scrolling for half a minute; this ends it
  await expect.poll(() => consoleIn(app)).toContain('>>>');
}

for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing that shuts people out of the page and its menus, ${theme}`, async ({ app }) => {
    await openApp(app, { theme });
    expect(await violationsOn(app), 'as it opens').toEqual([]);

    await pasteProgram(app, 'from microbit import *\n');
    await app.type('display.');
    await until(app, '.cm-completionInfo');
    expect(await violationsOn(app), 'with the list of suggestions').toEqual([]);
    await app.press('Escape');

    await app.click('[data-testid=device]');
    await until(app, '[data-testid=board-calliope-mini-3]');
    expect(await violationsOn(app), 'with the menu of devices').toEqual([]);
  });
}

for (const { theme, module, drawing } of [
  { theme: 'light', module: 'microbit', drawing: 'svg.microbit' },
  { theme: 'dark', module: 'calliopemini', drawing: 'svg.calliope' },
] as const) {
  test(`axe finds nothing that shuts people out after a run of ${module}, with every panel, ${theme}`, async ({
    app,
  }) => {
    await openApp(app, { theme });
    await runOn(app, module);
    await until(app, drawing);
    expect(await violationsOn(app), 'with an error and the REPL').toEqual([]);
    for (const { panel, sign } of [
      { panel: 'sensors', sign: '.panel-open details' },
      { panel: 'radio', sign: '.panel-open li' },
      { panel: 'log', sign: '.panel-open tr.data' },
    ]) {
      await app.click(`[data-testid=panel-${panel}]`);
      await until(app, sign);
      await app.evaluate(() => {
        document.querySelectorAll('details').forEach((fold) => fold.setAttribute('open', ''));
      });
      expect(await violationsOn(app), `with the panel ${panel}`).toEqual([]);
    }
  });
}
