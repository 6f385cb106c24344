// npm run handbook: the handbook as a PDF for each language, in dist/handbook, printed by the page itself in the Chromium that the
// tests use. Each place in the program that it leads to is photographed there, and stands below the first section about it.
import { mkdir } from 'node:fs/promises';
import { chromium } from '@playwright/test';
import { engines } from './browsers.mjs';
import { Failure, main, note, root } from './progress.mjs';
import { serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const MADE = 'dist/handbook';
const LOCALES = { de: 'de-CH', fr: 'fr-CH', it: 'it-CH', en: 'en-GB' };
/** The course that is open in the pictures: it has a line, a goal, and a task. */
const OPEN = '?task=closed-line';
const SIZE = { width: 1180, height: 700 };
/** Long enough for a page to come and for its pictures to be drawn. */
const DRAWN_MS = 2_500;

/** In the page: the places that the printed handbook leads to. */
const PLACES = `[...new Set([...document.querySelectorAll('[data-show]')].map((one) => one.getAttribute('data-show')))]
  .filter((place) => place !== '')`;

/**
 * In the page: puts a picture below the first section about a place.
 *
 * @param {string} place
 * @param {string} address
 */
const putPicture = (place, address) => `(() => {
  const picture = Object.assign(new Image(), { alt: '', src: ${JSON.stringify(address)} });
  document.querySelector('[data-show="${place}"]')?.append(picture);
  return picture.decode();
})()`;

/**
 * A picture of a place in the program, as the address of an image.
 *
 * @param {import('@playwright/test').BrowserContext} context
 * @param {string} url
 * @param {string} place a page's address without `#`, or `@` and a mode of the arena
 */
async function pictureOf(context, url, place) {
  const page = await context.newPage();
  await page.goto(place.startsWith('@') ? `${url}${OPEN}` : `${url}${OPEN}#${place}`);
  await page.waitForLoadState('networkidle');
  if (place.startsWith('@')) await page.click(`[data-testid="mode-${place.slice(1)}"]`);
  await page.waitForTimeout(DRAWN_MS);
  const picture = await page.screenshot({ type: 'jpeg', quality: 80 });
  await page.close();
  return `data:image/jpeg;base64,${picture.toString('base64')}`;
}

/**
 * Prints the handbook in one language.
 *
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {string} language
 */
async function print(browser, url, language) {
  const context = await browser.newContext({ viewport: SIZE, locale: LOCALES[language], colorScheme: 'light' });
  const page = await context.newPage();
  await page.addInitScript('window.print = () => {}');
  await page.goto(`${url}#handbook`);
  await page.click('[data-testid="handbook-pdf"]');
  await page.waitForSelector('[data-testid="handbook-paper"]');
  const places = /** @type {string[]} */ (await page.evaluate(PLACES));
  for (const place of places) await page.evaluate(putPicture(place, await pictureOf(context, url, place)));
  const path = `${MADE}/parcours-handbook-${language}.pdf`;
  await page.pdf({ path: `${root}${path}`, preferCSSPageSize: true, tagged: true, outline: true });
  await context.close();
  note(`${path}, ${places.length} pictures`);
}

await main(import.meta.url, async () => {
  await setUpApp();
  const [{ env, missing }] = engines();
  if (missing) throw new Failure(`The handbook needs Chromium: ${missing}.`);
  await mkdir(`${root}${MADE}`, { recursive: true });
  const server = await serve({ port: 0 });
  const browser = await chromium.launch({ executablePath: env.PARCOURS_CHROMIUM });
  for (const language of Object.keys(LOCALES)) await print(browser, server.url, language);
  await browser.close();
  await server.close();
});
