import type { Page, Route } from '@playwright/test';
import { expect, test } from './app';
import { classLink } from './class-link';
import { on } from './page';
import { by } from './parts';

/** The visible message of a page that cannot start. */
const said = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const place = document.querySelector<HTMLElement>('.cannot-start');
    return place === null || getComputedStyle(place).visibility !== 'visible' ? '' : place.innerText.trim();
  });

const SCRIPT = /\/assets\/(page|index|main)-[^/]*\.js$/;
const answer =
  (status: number, contentType: string, body = '') =>
  (route: Route) =>
    route.fulfill({ status, contentType, body, headers: { 'X-Content-Type-Options': 'nosniff' } });

test.describe('a page whose first script', () => {
  for (const [what, how] of [
    ['is not there', answer(404, 'text/plain')],
    ['comes under a wrong type', answer(200, 'text/plain', 'export {}')],
    ['is a web page', answer(200, 'text/html', '<!doctype html>')],
    ['never comes', (route: Route) => route.abort()],
    ['is cut', answer(200, 'text/javascript', 'export const a = (')],
  ] as const)
    test(`${what} says so`, async ({ page }) => {
      await page.route(SCRIPT, how);
      await page.goto('./?lang=en');
      await expect.poll(() => said(page)).toMatch(/^Parcours does not start: its files do not arrive[^]*filter\.$/);
    });
});

test('a browser that is too old says which would do', async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(Array.prototype, 'at'));
  await page.route(SCRIPT, (route) => route.abort());
  await page.goto('./?lang=fr');
  await expect.poll(() => said(page)).toMatch(/^Ce navigateur est trop ancien/);
});

test('without JavaScript the page says that it needs it, and nothing else', async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(baseURL ?? '');
  const shown = page.locator('.cannot-start p:visible');
  await expect(shown).toHaveText([
    /braucht JavaScript/,
    /a besoin de JavaScript/,
    /ha bisogno di JavaScript/,
    /needs JavaScript/,
  ]);
  await context.close();
});

test('a page that starts holds itself to its own policy, which has no eval', async ({ page }) => {
  await page.goto('./');
  await page.locator(on('editor')).waitFor();
  const policies = await page.evaluate(() =>
    [...document.querySelectorAll('meta[http-equiv="Content-Security-Policy"]')].map((it) =>
      it.getAttribute('content'),
    ),
  );
  expect(policies).toHaveLength(1);
  expect(policies[0]).toContain("script-src 'self' 'wasm-unsafe-eval';");
  // In a moment of its own: what a test tool runs itself may do so.
  const refused = await page.evaluate(
    () =>
      new Promise((resolve) => {
        setTimeout(() => {
          try {
            resolve(String(Reflect.construct(Function, ['return 1'])));
          } catch (error) {
            resolve((error as Error).name);
          }
        });
      }),
  );
  expect(refused).toBe('EvalError');
});

test.describe('on a page that runs', () => {
  /** Late parts: how somebody gets to one, and what then is there. Before that something else may be pressed and come. */
  const LATE: readonly {
    name: string;
    press: string;
    there: string;
    width: number;
    hash?: string;
    before?: readonly [press: string, there: string];
  }[] = [
    { name: 'the card of the task', press: by('welcome-robot'), there: by('task-card'), width: 1366 },
    { name: 'the whole board', before: [by('welcome-robot'), by('task-card')], press: by('board-whole'), there: by('panel-sensors'), width: 1366 }, // prettier-ignore
    { name: 'the tools', press: by('mode-build'), there: '[data-tool=pen]', width: 1366 },
    { name: 'the menu', press: by('menu'), there: by('menu-help'), width: 390 },
    { name: 'the page for teachers', press: by('menu-teachers'), before: [by('menu'), by('menu-teachers')], there: by('desk-search'), width: 1366 }, // prettier-ignore
    { name: 'the dialog to share', press: by('share'), there: by('share-dialog'), width: 1366 },
    {
      name: 'the dialog to hand in',
      press: by('share'),
      there: by('hand-in-dialog'),
      width: 1366,
      hash: classLink().slice(2),
    },
  ];
  test.use({ locale: 'en-GB' });
  for (const { name, before, press, there, width, hash = '' } of LATE)
    test(`late, ${name} is asked for again when the network is back`, async ({ page }) => {
      await page.setViewportSize({ width, height: 844 });
      await page.goto(`./${hash}`);
      await page.locator(by(hash === '' ? 'welcome' : 'task-card')).waitFor();
      if (before !== undefined) {
        await page.click(before[0]);
        await page.locator(before[1]).waitFor();
      }
      await page.locator(press).waitFor();
      await page.waitForLoadState('networkidle'); // only what is asked for late is missing
      await page.route(/\/assets\//, (route) => route.abort());
      await page.click(press);
      await expect(page.locator('.notice')).toContainText('This part could not be loaded.');
      await page.unroute(/\/assets\//);
      await page.locator('.notice').getByRole('button', { name: 'Try again' }).click();
      await expect(page.locator(there).first()).toBeVisible();
    });

  test('a web page in the simulator’s place is told as that', async ({ page }) => {
    await page.route(/\.wasm$/, answer(200, 'text/html', '<!doctype html><title>Filter</title>'));
    await page.goto('./?lang=en');
    await page.locator(on('run')).click();
    await expect(page.locator('.notice')).toContainText('Something else arrives instead of the simulator');
  });

  test('a simulator that lets wait for itself is told of', async ({ page }) => {
    await page.route(/\.wasm$/, () => undefined);
    await page.goto('./?lang=en');
    await page.locator(on('run')).click();
    await expect(page.locator('.notice')).toContainText('The simulator is not there yet');
  });

  test('a policy that forbids WebAssembly is named', async ({ page }) => {
    await page.route(/\/(\?.*)?$/, async (route) => {
      const response = await route.fetch();
      const policy = (response.headers()['content-security-policy'] ?? '').replace(/'(wasm-)?unsafe-eval'/g, '');
      await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } });
    });
    await page.goto('./?lang=en');
    await page.locator(on('run')).click();
    await expect(page.locator('.notice')).toContainText('forbids WebAssembly');
  });
});
