// npm run screenshots: takes the pictures of the README and of docs/first-hour.md from the running app, with the Chromium
// that the tests use.
import { mkdir } from 'node:fs/promises';
import { chromium } from '@playwright/test';
import { engines } from './browsers.mjs';
import { browserTests } from './e2e.mjs';
import { Failure, main, note, root } from './progress.mjs';
import { serve } from './serve.mjs';
import { buildApp, setUp } from './setup.mjs';

/** @type {{ name: string, width: number, height: number, dark: boolean, tool?: string }[]} */
const PICTURES = [
  { name: 'app', width: 1440, height: 900, dark: false },
  { name: 'app-dark', width: 1440, height: 900, dark: true },
  { name: 'wide', width: 1920, height: 1080, dark: false, tool: 'wall' },
  { name: 'tablet', width: 820, height: 1180, dark: false, tool: 'pen' },
  { name: 'phone', width: 390, height: 844, dark: false, tool: 'block' },
  { name: 'phone-dark', width: 390, height: 844, dark: true },
];
/** Long enough for the first course's robot to have set off. */
const DRIVING_MS = 6_000;

/** Chooses a tool of the course editor; on a phone the arena and the tools are unfolded first. */
async function chooseTool(page, tool) {
  if (tool === undefined) return;
  const button = page.locator(`[data-tool="${tool}"]`);
  if (!(await button.isVisible())) await page.click('[data-testid="tools-toggle"]');
  await button.click();
}

/**
 * Opens the app as on a first visit, lets its first course drive for a while and takes a picture.
 *
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {{ name: string, width: number, height: number, dark: boolean, tool?: string }} picture `tool`: the one that is chosen.
 */
async function take(browser, url, { name, width, height, dark, tool }) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    locale: 'en-GB',
  });
  const page = await context.newPage();
  page.on('console', (message) => note(`${name}: the page says ${message.text()}`));
  await page.goto(url);
  await page.click('button.run');
  if (width < 600) await page.click('nav >> text=Arena');
  await chooseTool(page, tool);
  await page.waitForTimeout(DRIVING_MS);
  await page.screenshot({ path: `${root}docs/images/${name}.png` });
  await context.close();
  note(`docs/images/${name}.png`);
}

/** A pupil's first hour in every language: the test that goes this way keeps a picture of each step. */
async function takeFirstHours() {
  process.env['PARCOURS_PICTURES'] = `${root}docs/images`;
  const rows = await browserTests(['first-hour', '--project=chromium', '--workers=1']);
  if (rows.some(({ failed }) => failed > 0)) throw new Failure('The first hour failed.');
}

await main(import.meta.url, async () => {
  await setUp();
  await buildApp();
  const [{ env, missing }] = engines();
  if (missing) throw new Failure(`The pictures need Chromium: ${missing}.`);
  await mkdir(`${root}docs/images`, { recursive: true });
  const server = await serve({ port: 0 });
  const browser = await chromium.launch({ executablePath: env.PARCOURS_CHROMIUM });
  for (const picture of PICTURES) await take(browser, server.url, picture);
  await browser.close();
  await server.close();
  await takeFirstHours();
});
