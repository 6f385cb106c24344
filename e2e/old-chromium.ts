import { delimiter } from 'node:path';
import { chromium, type Page } from '@playwright/test';
import { playwrightApp, type App } from './app';

/** The programs of old Chromiums that are there (`scripts/old-browsers.mjs`), oldest first. */
export const oldChromiums = (): readonly string[] =>
  (process.env['PARCOURS_OLD_CHROMIUMS'] ?? '').split(delimiter).filter((path) => path !== '');

/** A page in an old Chromium. */
export interface OldPage {
  readonly app: App;
  readonly version: string;
  /** Uncaught exceptions of the page. */
  readonly faults: readonly string[];
  close(): Promise<void>;
}

/** Opens an old Chromium. They are made for servers: without a graphics card, and without a sandbox of their own. */
export async function openOldChromium(executablePath: string): Promise<OldPage> {
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--no-zygote', '--disable-gpu'] });
  const context = await browser.newContext({
    baseURL: process.env['PARCOURS_APP'] ?? 'http://localhost:8080/',
    viewport: { width: 1280, height: 800 },
    locale: 'en-GB',
    serviceWorkers: 'block',
  });
  const page = await context.newPage();
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  return { app: withoutLooking(page), version: browser.version(), faults, close: () => browser.close() };
}

/** Playwright looks whether a thing can be seen before it touches it, by a function that these do not have. */
function withoutLooking(page: Page): App {
  const app = playwrightApp('chromium', page);
  return {
    ...app,
    click: (css) =>
      app.evaluate((selector) => {
        const found = document.querySelector<HTMLElement>(selector);
        if (found === null) throw new Error(`There is no ${selector}.`);
        found.click();
      }, css),
    fill: (css, text) =>
      app.evaluate(
        (typed) => {
          const field = document.querySelector<HTMLInputElement>(typed.css);
          if (field === null) throw new Error(`There is no ${typed.css}.`);
          field.value = typed.text;
          field.dispatchEvent(new Event('input', { bubbles: true }));
        },
        { css, text },
      ),
  };
}
