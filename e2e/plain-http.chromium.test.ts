import { chromium, type Browser, type Page } from '@playwright/test';
import { playwrightApp, expect, test } from './app';
import { linkTo, openClass, paste, RIGHT } from './class-page';
import { appAddress } from './hosts';
import { on } from './page';
import { by, until } from './parts';

/** As other computers of a school reach `npm start`: by a name of the network, without a certificate. */
const ORIGIN = appAddress().replace('localhost', 'school.lan');

test.describe('over plain http', () => {
  let browser: Browser;
  let page: Page;
  const faults: string[] = [];
  test.beforeEach(async ({ launchOptions }) => {
    const rules = '--host-resolver-rules=MAP school.lan 127.0.0.1';
    browser = await chromium.launch({ ...launchOptions, args: [...(launchOptions.args ?? []), rules] });
    page = await (await browser.newContext({ baseURL: ORIGIN, locale: 'en-GB' })).newPage();
    faults.length = 0;
    page.on('pageerror', ({ message }) => faults.push(message));
  });
  test.afterEach(async () => {
    await browser.close();
    expect(faults).toEqual([]);
  });

  test('a program runs, and the menu’s windows open', async () => {
    const app = playwrightApp('chromium', page);
    await app.goto('./');
    await until(app, on('editor'));
    expect(await app.evaluate(() => [isSecureContext, 'randomUUID' in crypto])).toEqual([false, false]);
    await app.click(on('run'));
    await expect.poll(() => app.text('.pane-console')).toContain('program ended');
    for (const [hash, id] of [
      ['make-series', 'series-title'],
      ['courses', 'courses'],
      ['robots', 'robots'],
    ] as const) {
      // prettier-ignore
      await app.goto(`./#${hash}`);
      await until(app, id === 'series-title' ? by(id) : '.gallery');
    }
  });

  test('a class is checked', async () => {
    const app = playwrightApp('chromium', page);
    await openClass(app, 'closed-line');
    await paste(app, `Ada: ${linkTo(RIGHT)}`);
    await until(app, by('class-table'));
    await expect.poll(() => app.text(by('class-table')), { timeout: 40_000 }).toMatch(/Ada\W+bestanden/);
  });
});
