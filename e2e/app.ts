import { test as base, chromium, expect as playwrightExpect, firefox, type Browser, type Page } from '@playwright/test';
import { Lent, type Profile, type Size, type Wish } from './lent';
import { startScreen, type Screen } from './screen';
import { WebKitSession, type PageCode } from './webkit';

const pollQuickly: typeof playwrightExpect.poll = (actual, how) =>
  playwrightExpect.poll(actual, { intervals: [50, 100, 250], ...(typeof how === 'string' ? { message: how } : how) });

/**
 * Playwright's `expect`, whose `poll` looks again every 250 ms: left alone it soon looks once a second only, and that
 * adds up over hundreds of tests.
 */
export const expect = new Proxy(playwrightExpect, {
  get: (target, name) => (name === 'poll' ? pollQuickly : (Reflect.get(target, name) as unknown)),
});

/** A place in the window, in CSS px from its upper left corner. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** The mouse's main button, or the one that opens menus. */
export type MouseButton = 'left' | 'right';

/** A page in any of the three engines, as tests use it. Elements are named by CSS selectors. */
export interface App {
  readonly engine: string;
  /** Opens an address, relative to the app's. */
  goto(address: string): Promise<void>;
  reload(): Promise<void>;
  /** Runs code in the page and waits for what it promises. */
  evaluate<R, A = null>(code: PageCode<A, R>, argument?: A): Promise<R>;
  /** Runs code in the page of a frame, wherever that page comes from. */
  inFrame<R, A = null>(frame: string, code: PageCode<A, R>, argument?: A): Promise<R>;
  click(css: string): Promise<void>;
  /** Replaces the text of an input. */
  fill(css: string, text: string): Promise<void>;
  /** The visible text. */
  text(css: string): Promise<string>;
  /** Presses keys together, by Playwright's names: `press('Control', 'Enter')`, `press('a')`. */
  press(...keys: string[]): Promise<void>;
  /** Presses keys one after the other. */
  strike(keys: readonly string[]): Promise<void>;
  /** Holds one key down until `release`. */
  hold(key: string): Promise<void>;
  release(key: string): Promise<void>;
  /** Types characters into whatever has the focus. */
  type(text: string): Promise<void>;
  /** Presses the mouse on the middle of an element and keeps it down until `letGo`. */
  grab(css: string): Promise<void>;
  letGo(): Promise<void>;
  /** Draws with the mouse: down at the first place of the window (CSS px), through the others, up at the last. */
  draw(places: readonly Place[], button?: MouseButton): Promise<void>;
  screenshot(): Promise<Buffer>;
}

/** WebDriver's code points for named keys (W3C WebDriver §17.4.2). */
const KEYS: Readonly<Record<string, string>> = {
  Backspace: '\uE003',
  Tab: '\uE004',
  Enter: '\uE007',
  Shift: '\uE008',
  Control: '\uE009',
  Alt: '\uE00A',
  Escape: '\uE00C',
  Space: '\uE00D',
  End: '\uE010',
  Home: '\uE011',
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
  Delete: '\uE017',
  F1: '\uE031',
  F5: '\uE035',
  F8: '\uE038',
};

/** The same facade over a page that Playwright drives. */
export function playwrightApp(engine: string, page: Page): App {
  return {
    engine,
    goto: async (address) => {
      await page.goto(address);
    },
    reload: async () => {
      await page.reload();
    },
    evaluate: (code, argument) => page.evaluate(code as (argument: unknown) => unknown, argument) as Promise<never>,
    inFrame: async (css, code, argument) => {
      const frame = await (await page.waitForSelector(css)).contentFrame();
      if (frame === null) throw new Error(`${css} is no frame.`);
      return frame.evaluate(code as (argument: unknown) => unknown, argument) as Promise<never>;
    },
    click: (css) => page.click(css),
    fill: (css, text) => page.fill(css, text),
    text: (css) => page.innerText(css),
    press: (...keys) => page.keyboard.press(keys.join('+')),
    strike: async (keys) => {
      for (const key of keys) await page.keyboard.press(key);
    },
    hold: (key) => page.keyboard.down(key),
    release: (key) => page.keyboard.up(key),
    type: (text) => page.keyboard.type(text),
    grab: async (css) => {
      await page.hover(css);
      await page.mouse.down();
    },
    letGo: () => page.mouse.up(),
    draw: async ([first, ...others], button = 'left') => {
      if (first === undefined) return;
      await page.mouse.move(first.x, first.y);
      await page.mouse.down({ button });
      for (const { x, y } of others) await page.mouse.move(x, y);
      await page.mouse.up({ button });
    },
    screenshot: () => page.screenshot(),
  };
}

/** The same facade over WebKitGTK. */
function webkitApp(session: WebKitSession, baseURL: string): App {
  return {
    engine: 'webkit',
    goto: (address) => session.goto(new URL(address, baseURL).href),
    reload: () => session.reload(),
    evaluate: (code, argument) => session.evaluate(code, argument),
    inFrame: (frame, code, argument) => session.inFrame(frame, code, argument),
    click: (css) => session.click(css),
    fill: (css, text) => session.fill(css, text),
    text: (css) => session.text(css),
    press: (...keys) => session.press(keys.map((key) => KEYS[key] ?? key)),
    strike: (keys) => session.strike(keys.map((key) => KEYS[key] ?? key)),
    hold: (key) => session.hold(KEYS[key] ?? key),
    release: (key) => session.release(KEYS[key] ?? key),
    type: (text) => session.type(text),
    grab: (css) => session.grab(css),
    letGo: () => session.letGo(),
    draw: (places, button) => session.draw(places, button === 'right' ? 2 : 0),
    screenshot: () => session.screenshot(),
  };
}

interface Fixtures {
  readonly app: App;
  /** Opens the app of another pupil: a browser profile that shares nothing with the first one. */
  readonly another: () => Promise<App>;
}

interface WorkerFixtures {
  readonly ownScreen: Screen | null;
  readonly browserOfEngine: Browser | null;
  /** The profile that one test leaves to the next. A test that fails ends the worker, and its profile with it. */
  readonly lent: Lent;
}

const STARTERS = { chromium, firefox };

/**
 * Playwright's `test` with one more fixture, `app`. A test that asks for `app` runs in all three engines;
 * Playwright's own `page` is for tests of Chromium and Firefox alone.
 */
export const test = base.extend<Fixtures, WorkerFixtures>({
  ownScreen: [
    async ({}, use, info) => {
      const screen = info.project.name === 'chromium' ? null : await startScreen();
      await use(screen);
      await screen?.close();
    },
    { scope: 'worker', auto: true },
  ],
  browserOfEngine: [
    async ({ ownScreen: _first, headless, launchOptions, channel }, use, info) => {
      const starter = STARTERS[info.project.name as keyof typeof STARTERS] as (typeof STARTERS)['chromium'] | undefined;
      const browser = await starter?.launch({ ...launchOptions, headless, ...(channel !== undefined && { channel }) });
      await use(browser ?? null);
      await browser?.close();
    },
    { scope: 'worker' },
  ],
  lent: [
    async ({ browserOfEngine }, use) => {
      const lent = new Lent((wish) => openProfile(browserOfEngine, wish));
      await use(lent);
      await lent.close();
    },
    { scope: 'worker' },
  ],
  another: async ({ browserOfEngine, lent, baseURL, viewport, serviceWorkers }, use) => {
    const opened: Profile[] = [];
    await use(async () => {
      lent.spoil(); // its window took the focus from the first one's
      const one = await openProfile(browserOfEngine, wishOf(baseURL, viewport, serviceWorkers));
      opened.push(one);
      return one.app;
    });
    for (const one of opened) await one.close();
  },
  app: async ({ lent, baseURL, viewport, serviceWorkers }, use, info) => {
    const { app } = await lent.take(wishOf(baseURL, viewport, serviceWorkers));
    await use(app);
    if (info.status === info.expectedStatus) return lent.giveBack();
    lent.spoil();
    const body = await app.screenshot().catch(() => null);
    if (body) await info.attach('screen.png', { body, contentType: 'image/png' });
    return lent.giveBack();
  },
});

/**
 * The same, with a `page` that is borrowed as well (Chromium): for tests that neither reroute nor listen to it, and leave no
 * scripts in it.
 */
export const warmTest = test.extend({
  page: async ({ lent, baseURL, viewport, serviceWorkers, hasTouch, isMobile }, use, info) => {
    const wish = { ...wishOf(baseURL, viewport, serviceWorkers), hasTouch, isMobile };
    const { page } = await lent.take(wish);
    if (page === null) throw new Error('WebKitGTK has no page of Playwright.');
    await page.setViewportSize(wish.viewport); // the test before may have changed it
    await use(page);
    if (info.status !== info.expectedStatus) lent.spoil();
    await lent.giveBack();
  },
});

const wishOf = (
  baseURL: string | undefined,
  viewport: Size | null,
  serviceWorkers: 'allow' | 'block' | undefined,
): Wish => ({
  baseURL: baseURL ?? 'http://localhost:8080/',
  viewport: viewport ?? { width: 1280, height: 800 },
  serviceWorkers: serviceWorkers ?? 'block',
});

function openProfile(browser: Browser | null, wish: Wish): Promise<Profile> {
  return browser ? openPlaywright(browser, wish) : openWebKit(wish);
}

async function openPlaywright(browser: Browser, wish: Wish): Promise<Profile> {
  const context = await browser.newContext(wish);
  const page = await context.newPage();
  return {
    page,
    app: playwrightApp(browser.browserType().name(), page),
    restHand: () => page.mouse.move(0, 0),
    close: () => context.close(),
  };
}

async function openWebKit({ baseURL, viewport }: Wish): Promise<Profile> {
  const session = await WebKitSession.start();
  await session.resize(viewport.width, viewport.height);
  return {
    page: null,
    app: webkitApp(session, baseURL),
    restHand: () => session.restHand(),
    close: () => session.close(),
  };
}
