// npm run handbook: the handbook as a PDF for each language, in dist/handbook, printed by the page itself in the Chromium that the
// tests use. With --pictures its pictures are first taken anew of the page; they belong to the sources.
import { mkdir } from 'node:fs/promises';
import { chromium } from '@playwright/test';
import { engines } from './browsers.mjs';
import { takePictures } from './handbook-pictures.mjs';
import { Failure, main, note, root } from './progress.mjs';
import { serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const MADE = 'dist/handbook';
const LOCALES = { de: 'de-CH', fr: 'fr-CH', it: 'it-CH', en: 'en-GB' };
const SIZE = { width: 1180, height: 700 };

/** In the page: true once all pictures are there. */
const HAS_PICTURES = `[...document.querySelectorAll('[data-testid="handbook-picture"]')].every(({ complete }) => complete)`;

/**
 * Prints the handbook in one language.
 *
 * @param {import('@playwright/test').BrowserContext} context
 * @param {string} url
 * @param {string} language
 */
async function print(context, url, language) {
  const page = await context.newPage();
  await page.addInitScript('window.print = () => {}');
  await page.goto(`${url}#handbook`);
  await page.click('[data-testid="handbook-pdf"]');
  await page.waitForSelector('[data-testid="handbook-paper"]');
  await page.waitForFunction(HAS_PICTURES);
  const path = `${MADE}/parcours-handbook-${language}.pdf`;
  await page.pdf({ path: `${root}${path}`, preferCSSPageSize: true, tagged: true, outline: true });
  await context.close();
  note(path);
}

await main(import.meta.url, async () => {
  await setUpApp();
  const [{ env, missing }] = engines();
  if (missing) throw new Failure(`The handbook needs Chromium: ${missing}.`);
  await mkdir(`${root}${MADE}`, { recursive: true });
  const browser = await chromium.launch({ executablePath: env.PARCOURS_CHROMIUM });
  const languages = Object.keys(LOCALES);
  const open = (language) => browser.newContext({ viewport: SIZE, locale: LOCALES[language], colorScheme: 'light' });
  let server = await serve({ port: 0 });
  if (process.argv.includes('--pictures')) {
    await takePictures(open, server.url, languages);
    await server.close();
    await setUpApp();
    server = await serve({ port: 0 });
  }
  for (const language of languages) await print(await open(language), server.url, language);
  await browser.close();
  await server.close();
});
