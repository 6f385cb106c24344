// npm run screenshots: takes pictures of the running app with the Chromium that the tests use: those of the README, which
// are kept in docs/images; into dist/pictures other looks, and the steps of docs/first-hour.md in every language.
import { mkdir } from 'node:fs/promises';
import { chromium } from '@playwright/test';
import { engines } from './browsers.mjs';
import { browserTests } from './e2e.mjs';
import { Failure, main, note, root } from './progress.mjs';
import { serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const KEPT = 'docs/images';
const MADE = 'dist/pictures';

/** @typedef {{ path: string, width: number, height: number, dark: boolean, tool?: string }} Picture `tool`: the one that is chosen */

/** @type {Picture[]} */
const PICTURES = [
  { path: `${KEPT}/app.png`, width: 1440, height: 900, dark: false },
  { path: `${MADE}/app-dark.png`, width: 1440, height: 900, dark: true },
  { path: `${MADE}/wide.png`, width: 1920, height: 1080, dark: false, tool: 'wall' },
  { path: `${KEPT}/tablet.png`, width: 820, height: 1180, dark: false, tool: 'pen' },
  { path: `${KEPT}/phone.png`, width: 390, height: 844, dark: false, tool: 'block' },
  { path: `${MADE}/phone-dark.png`, width: 390, height: 844, dark: true },
];
/** Long enough for the robot to have set off. */
const DRIVING_MS = 6_000;

/** Chooses a tool of the course editor; on a phone the arena and the tools are unfolded first. */
async function chooseTool(page, tool) {
  if (tool === undefined) return;
  const button = page.locator(`[data-tool="${tool}"]`);
  if (!(await button.isVisible())) await page.click('[data-testid="mode-build"]');
  await button.click();
}

/**
 * Opens the closed line, lets the robot drive for a while and takes a picture.
 *
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {Picture} picture
 */
async function take(browser, url, { path, width, height, dark, tool }) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    locale: 'en-GB',
  });
  const page = await context.newPage();
  page.on('console', (message) => note(`${path}: the page says ${message.text()}`));
  await page.goto(`${url}?task=closed-line`);
  await page.click('button.run');
  if (width < 600) await page.click('nav >> text=Arena');
  await chooseTool(page, tool);
  await page.waitForTimeout(DRIVING_MS);
  await page.screenshot({ path: `${root}${path}` });
  await context.close();
  note(path);
}

/** A pupil's first hour in every language: the test that takes these steps keeps a picture of each. */
async function takeFirstHours() {
  process.env['PARCOURS_PICTURES'] = `${root}${MADE}`;
  const rows = await browserTests(['first-hour', '--project=chromium', '--workers=1']);
  if (rows.some(({ failed }) => failed > 0)) throw new Failure('The first hour failed.');
}

await main(import.meta.url, async () => {
  await setUpApp();
  const [{ env, missing }] = engines();
  if (missing) throw new Failure(`The pictures need Chromium: ${missing}.`);
  await mkdir(`${root}${MADE}`, { recursive: true });
  const server = await serve({ port: 0 });
  const browser = await chromium.launch({ executablePath: env.PARCOURS_CHROMIUM });
  for (const picture of PICTURES) await take(browser, server.url, picture);
  await browser.close();
  await server.close();
  await takeFirstHours();
});
