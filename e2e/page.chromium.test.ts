import { expect, test } from '@playwright/test';
import { on } from './page';

const PROGRAM_MS = 1_000;

// Playwright says on the console that it blocks them.
test.use({ serviceWorkers: 'allow' });

// What a test has rerouted may still be under way when it ends.
test.afterEach(({ page }) => page.unrouteAll({ behavior: 'ignoreErrors' }));

test('a visit with a run asks nobody but the own host, and the page has nothing to complain about', async ({
  page,
  baseURL,
}) => {
  const complaints: string[] = [];
  const strangers: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!request.url().startsWith(baseURL ?? '')) strangers.push(request.url());
  });
  await page.goto('./');
  await page.click(on('run'));
  await page.waitForTimeout(PROGRAM_MS);
  await page.click(on('stop'));
  await expect(page.locator(on('stop'))).toBeHidden();
  expect(complaints).toEqual([]);
  expect(strangers).toEqual([]);
});

test('the worker of a run has nothing left that reaches out, whether or not its header is sent', async ({ page }) => {
  // Chromium's service worker would answer with what it has kept, and the route would not be asked.
  await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, 'serviceWorker'));
  let isBare = false;
  await page.route(/\/assets\/worker-[^/]*\.js$/, async (route) => {
    const answer = await route.fetch();
    const { 'content-security-policy': policy, ...headers } = answer.headers();
    expect(policy).toContain("connect-src 'none'");
    await route.fulfill({ response: answer, headers: isBare ? headers : answer.headers() });
  });
  const left = async (): Promise<string[]> => {
    await page.goto('./');
    await page.click(on('run'));
    await expect(page.locator(on('stop'))).toBeEnabled();
    // Asked for now: one that is announced may be of the page before, which is closing; its own may be told of a little later.
    const find = () => page.workers().find((one) => one.url().includes('/assets/worker-'));
    await expect.poll(() => find() !== undefined).toBe(true);
    const worker = find();
    if (worker === undefined) throw new Error('There is no worker.');
    return worker.evaluate(() => {
      const outwards = [
        ...['fetch', 'XMLHttpRequest', 'WebSocket', 'WebSocketStream', 'WebTransport', 'EventSource', 'importScripts'],
        ...['Worker', 'SharedWorker', 'BroadcastChannel', 'FontFace', 'fonts', 'indexedDB', 'caches', 'cookieStore'],
      ];
      const onNavigator = ['storage', 'storageBuckets', 'serviceWorker', 'locks'];
      return [
        ...outwards.filter((name) => Reflect.get(globalThis, name) !== undefined),
        ...onNavigator.filter((name) => Reflect.get(navigator, name) !== undefined),
      ];
    });
  };
  expect(await left()).toEqual([]);
  isBare = true;
  expect(await left()).toEqual([]);
});

test('the help leads to the licences of everything in the app', async ({ page }) => {
  await page.goto('./');
  await page.click('[data-testid=menu]');
  await page.click('[data-testid=menu-help]');
  await page.locator('[data-testid=guide-licences]').scrollIntoViewIfNeeded();
  const opened = page.waitForEvent('popup');
  await page.click('[data-testid=guide-licences]');
  const licences = await opened;
  await expect(licences.locator('body')).toContainText('Damien P. George');
  expect(licences.url()).toMatch(/\/LICENSES\.txt$/);
});
