import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';

/** The panes that are to be seen. */
const panes = (app: App): Promise<string> =>
  app.evaluate(() =>
    ['code', 'board', 'arena', 'console']
      .filter((name) => (document.querySelector(`.pane-${name}`)?.getBoundingClientRect().width ?? 0) > 0)
      .join(),
  );
const has = (app: App, css: string): Promise<boolean> =>
  app.evaluate((selector) => document.querySelector(selector) !== null, css);

for (const show of ['board,arena', 'arena', 'board', 'console', 'code,console', 'code,board', 'arena,console']) {
  test(`shows ${show} alone where the address asks for it, with Run at hand`, IN_ONE_ENGINE, async ({ app }) => {
    await app.goto(`?show=${show}`);
    await expect.poll(() => panes(app)).toBe(show);
    await expect.poll(() => has(app, '[data-testid=run]')).toBe(true);
    expect(await has(app, '.brand')).toBe(false);
    // The editor comes late, and only where there is one.
    if (show.includes('code')) await expect.poll(() => has(app, '.code-editor')).toBe(true);
    else expect(await has(app, '.pane-code')).toBe(false);
    await app.click('[data-testid=run]');
    await expect.poll(() => has(app, '[data-testid=stop]')).toBe(true);
    await app.click('[data-testid=stop]');
    await expect.poll(() => has(app, '[data-testid=stop]')).toBe(false);
  });
}
