import { setTimeout as sleep } from 'node:timers/promises';
import type { Page } from '@playwright/test';
import type { App } from './app';

/** The size of a window's inside, in CSS px. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** The profile that a test asks for. */
export interface Wish {
  readonly baseURL: string;
  readonly viewport: Size;
  readonly serviceWorkers: 'allow' | 'block';
  readonly hasTouch?: boolean;
  readonly isMobile?: boolean;
}

/** A browser profile with one window. */
export interface Profile {
  readonly app: App;
  /** Playwright's own, where Playwright drives the browser. */
  readonly page: Page | null;
  /** Moves the mouse to where nothing of the next page answers it. */
  restHand(): Promise<void>;
  close(): Promise<void>;
}

/** Firefox, driven over WebDriver BiDi, now and then answers no more in the middle of leaving a page, also when that is closed. */
const EMPTIED_WITHIN_MS = 15_000;
const CLOSED_WITHIN_MS = 10_000;

/** The address of what has the app's storage and loads in no time: here a page is emptied, and filled for the next test. */
export const STORAGE = './logo.svg';

/**
 * A profile that one test after the other borrows: to open the page in one that is warm takes a third of what it takes in
 * a new one (1.0 s of a processor instead of 2.9 s in Chromium, measured 2026-11-28, spread 0.8 to 1.3). It is given back
 * with empty storage at `STORAGE`. What cannot be emptied is closed instead: after a visit to another site, whose
 * frames have storage of their own; with a service worker; after a second window; after a failure.
 */
export class Lent {
  private profile: Profile | null = null;
  private wish: Wish | null = null;
  private isSpoilt = false;
  private isAtStorage = false;

  constructor(private readonly open: (wish: Wish) => Promise<Profile>) {}

  /** The profile of before where it is such a one, else a new one. */
  async take(wish: Wish): Promise<Pick<Profile, 'app' | 'page'>> {
    if (this.profile === null || JSON.stringify(this.wish) !== JSON.stringify(wish)) {
      await this.close();
      this.profile = await this.open(wish);
      this.wish = wish;
      this.isAtStorage = false;
    }
    this.isSpoilt = wish.serviceWorkers === 'allow';
    return { app: this.watched(this.profile.app, wish.baseURL), page: this.profile.page };
  }

  /** Marks the page as unusable for further tests. */
  spoil(): void {
    this.isSpoilt = true;
  }

  /** Ends the borrowing. */
  async giveBack(): Promise<void> {
    if (this.profile !== null && !this.isSpoilt)
      await within(EMPTIED_WITHIN_MS, emptied(this.profile)).catch((error: unknown) => {
        note(`A page is closed instead of lent: ${String(error)}`);
        this.spoil();
      });
    this.isAtStorage = !this.isSpoilt;
    if (this.isSpoilt) await this.close();
  }

  /** Closes the profile; one that does not answer goes with its browser, at the end of the test worker. */
  async close(): Promise<void> {
    const { profile } = this;
    this.profile = null;
    if (profile === null) return;
    const timer = new AbortController();
    const late = sleep(CLOSED_WITHIN_MS, null, { signal: timer.signal }).then(
      () => note('A page that does not answer is left open.'),
      () => undefined,
    );
    await Promise.race([profile.close(), late]).finally(() => timer.abort());
  }

  /** The same app, which is spoilt by a visit to another site, and which does not go to `STORAGE` if it has been left there. */
  private watched(app: App, baseURL: string): App {
    return {
      ...app,
      goto: (address) => {
        const isThere = this.isAtStorage && address === STORAGE;
        this.isAtStorage = false;
        if (isThere) return Promise.resolve();
        const { protocol, hostname } = new URL(address, baseURL);
        if (protocol !== 'about:' && hostname !== new URL(baseURL).hostname) this.spoil();
        return app.goto(address);
      },
    };
  }
}

const note = (what: string): void => void process.stdout.write(`${what}\n`);

/** Waits for a promise, and fails after this time. */
async function within<T>(ms: number, promise: Promise<T>): Promise<T> {
  const timer = new AbortController();
  const late = sleep(ms, null, { signal: timer.signal }).then(() => {
    throw new Error(`It was not empty after ${ms} ms.`);
  });
  try {
    return await Promise.race([promise, late]);
  } finally {
    timer.abort();
    late.catch(() => undefined);
  }
}

/**
 * Leaves the page, and takes away all that it has stored; by way of an empty page, from which no other inherits that somebody
 * has clicked.
 */
async function emptied(profile: Profile): Promise<void> {
  const { app } = profile;
  await app.goto('about:blank');
  await app.goto(STORAGE);
  await profile.restHand();
  await app.evaluate(async () => {
    localStorage.clear();
    sessionStorage.clear();
    for (const { name = '' } of await indexedDB.databases())
      await new Promise<void>((done, failed) => {
        const request = indexedDB.deleteDatabase(name);
        request.onsuccess = () => done();
        request.onerror = request.onblocked = () => failed(new Error(`${name} cannot be deleted.`));
      });
    for (const name of await caches.keys()) await caches.delete(name);
  });
}
