import type { Browser, CDPSession, Page } from '@playwright/test';
import { PLACES, watchOptions, watchPage } from './watch';

/** The browser in which the page is measured. */
export interface Stage {
  /** Starts a Chromium that has seen nothing yet: every start has a profile of its own. */
  launch(): Promise<Browser>;
  /** Address of the built app. */
  readonly url: string;
  /** Takes the time to drive for minutes as people see it, instead of as fast as possible. */
  readonly long: boolean;
}

/** A page of its own browser. */
export interface Opened {
  readonly browser: Browser;
  readonly page: Page;
  /** Chromium's own tools for this page. */
  readonly tools: CDPSession;
}

/** How a page is opened. */
export interface OpenOptions {
  /** How many times slower the page's own thread shall be. Chromium cannot slow workers down. */
  readonly throttle?: number;
  /** Presses Run as soon as the editor is usable. */
  readonly pressRun?: boolean;
  readonly url?: string;
  /** Work left open by an earlier visit, as the browser's storage holds it: `closedLine`, `fourRobots`. */
  readonly work?: string;
  /** Leaves the service worker out. The tools keep it alive; otherwise it ends 30 s after its work, and its 30 MB with it. */
  readonly noServiceWorker?: boolean;
}

/** Longest wait for anything, in ms. */
const PATIENCE_MS = 60_000;

/** Opens the app in a new browser, measures, and ends the browser. */
export async function withPage<T>(
  stage: Stage,
  { throttle = 1, pressRun = false, url = stage.url, work, noServiceWorker = false }: OpenOptions,
  measure: (opened: Opened) => Promise<T>,
): Promise<T> {
  const browser = await stage.launch();
  try {
    const page = await browser.newPage({
      viewport: { width: 1280, height: 800 },
      serviceWorkers: noServiceWorker ? 'block' : 'allow',
    });
    page.setDefaultTimeout(PATIENCE_MS);
    const tools = await page.context().newCDPSession(page);
    await page.addInitScript(watchPage, watchOptions(pressRun));
    if (work !== undefined) await page.addInitScript((kept) => sessionStorage.setItem('parcours.work', kept), work);
    if (throttle > 1) await tools.send('Emulation.setCPUThrottlingRate', { rate: throttle });
    await page.goto(url, { waitUntil: 'commit' });
    return await measure({ browser, page, tools });
  } finally {
    await browser.close();
  }
}

/**
 * Waits until something is so in the page, looking five times a second: looking costs time, too.
 *
 * @param patienceMs how long it may take at most
 */
export async function until<A>(
  page: Page,
  condition: (argument: A) => boolean,
  argument: A,
  patienceMs = PATIENCE_MS,
): Promise<void> {
  const options = { polling: 200, timeout: patienceMs };
  await page.waitForFunction(condition as (argument: unknown) => boolean, argument, options);
}

/** Waits until the editor takes text. */
export const untilUsable = (page: Page): Promise<void> => until(page, () => window.bench.usableMs !== null, null);

/** Waits until the robot has moved. */
export const untilMoving = (page: Page): Promise<void> => until(page, () => window.bench.movingMs !== null, null);

/** Waits until all files are kept for visits without a network: from then on nothing comes any more. */
export async function untilKept(page: Page): Promise<void> {
  await page.evaluate(() => void navigator.serviceWorker.ready.then(() => (window.bench.isKept = true)));
  await until(page, () => window.bench.isKept, null);
}

/** Chooses the highest speed in the menu. */
export async function chooseMaximumSpeed(page: Page): Promise<void> {
  await page.click(PLACES.speed);
  await page.locator(PLACES.choice).last().click();
}

/** Replaces the program in the editor, as one paste. */
export async function pasteProgram(page: Page, program: string): Promise<void> {
  await page.click(PLACES.editor);
  await page.keyboard.press('ControlOrMeta+a');
  await page.evaluate(
    ({ css, text }) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', text);
      const paste = new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true });
      document.querySelector(css)?.dispatchEvent(paste);
    },
    { css: PLACES.editor, text: program },
  );
  const shown = await page.innerText(PLACES.editor);
  if (shown.trim() !== program) throw new Error(`The editor shows "${shown}" instead of "${program}".`);
}
