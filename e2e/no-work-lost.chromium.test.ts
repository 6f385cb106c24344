import { spawn, type ChildProcess } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { chromium, expect, test, type BrowserContext, type Page } from '@playwright/test';

import type { Point, Stroke } from '../src/scene/scene';
import { playwrightApp } from './app';
import { inWindow } from './arena';
import { sceneOf } from './course';
import { on } from './page';
import { by } from './parts';

/** Longest loss after the tab died, and after the whole browser was killed, in ms. */
const TAB_MS = 1000;
const BROWSER_MS = 3000;

/** More of each by hand: `NO_WORK_LOST=10 npm run e2e -- no-work-lost`. */
const TIMES = Number(process.env['NO_WORK_LOST'] ?? 1);

/** How somebody works while it happens. */
type Manner = 'fast' | 'with pauses' | 'drawing';

/** The work done up to a time, in ms: characters typed, or places of the pen. */
type Done = { readonly count: number; readonly atMs: number }[];

const MANNERS: readonly Manner[] = ['fast', 'with pauses', 'drawing'];

for (let time = 0; time < TIMES; time += 1)
  for (const [place, manner] of MANNERS.entries())
    test(`a tab that dies costs at most a second: ${manner}, ${String(time)}.${String(place)}`, async ({ context }) => {
      const page = await openAt(context, './');
      const done = await workUntil(page, manner, 1500 + Math.random() * 5000, () => crash(page));
      const missing = await missingIn(await openAt(context, './'), manner, done);
      note(test.info().title, missing);
      expect(missing).toBeLessThanOrEqual(TAB_MS);
    });

for (let time = 0; time < TIMES; time += 1)
  for (const [place, manner] of MANNERS.entries())
    test(`a browser that is killed costs at most three seconds: ${manner}, ${String(time)}.${String(place)}`, async ({
      baseURL,
    }) => {
      const profile = await mkdtemp(join(tmpdir(), 'parcours-killed-'));
      const url = baseURL ?? '';
      const browsers: KillableBrowser[] = [];
      const start = async (): Promise<KillableBrowser> => {
        const browser = await startBrowser(profile);
        browsers.push(browser);
        return browser;
      };
      try {
        const first = await start();
        const page = await openAt(first.context, url);
        const done = await workUntil(page, manner, 1500 + Math.random() * 5000, () => first.kill());
        const second = await start();
        const missing = await missingIn(await openAt(second.context, url), manner, done);
        note(test.info().title, missing);
        expect(missing).toBeLessThanOrEqual(BROWSER_MS);
      } finally {
        for (const browser of browsers) await browser.kill();
        await rm(profile, { recursive: true, force: true, maxRetries: 5 });
      }
    });

const note = (what: string, ms: number): void => {
  test.info().annotations.push({ type: 'missing', description: `${what}: ${ms.toFixed(0)} ms` });
  if (TIMES > 1) process.stdout.write(`missing ${ms.toFixed(0)} ms | ${what}\n`);
};

async function openAt(context: BrowserContext, url: string): Promise<Page> {
  const page = await context.newPage();
  await page.addInitScript(() => {
    if (localStorage.getItem('parcours.settings') === null)
      localStorage.setItem('parcours.settings', '{"language":"en","welcomed":true}');
  });
  await page.goto(url);
  await page.waitForSelector(`${on('editor')}[contenteditable=true]`, { state: 'attached' }); // whoever built still does, where no program is in sight
  return page;
}

/** Works without an end until it happens; returns what was done when. */
async function workUntil(page: Page, manner: Manner, ms: number, end: () => Promise<unknown>): Promise<Done> {
  const done: Done = [];
  let isOver = false;
  const work = (manner === 'drawing' ? draw : type)(page, done, () => isOver, manner === 'with pauses');
  const ended = work.catch(() => undefined); // it happens in the middle of a stroke or a key
  await expect.poll(() => done.length, { timeout: 30_000 }).toBeGreaterThan(0);
  await sleep(ms);
  done.push({ count: Infinity, atMs: performance.now() });
  isOver = true;
  await end();
  await Promise.race([ended, sleep(500)]); // a dead page may leave a key without an answer
  return done;
}

/** Between two keys, in ms: faster than a key that is held repeats. With none the browser hardly gets to do anything else. */
const KEY_MS = 10;

/** Types line after line, each with its number, and notes when a line was in the editor. */
async function type(page: Page, done: Done, isOver: () => boolean, pauses: boolean): Promise<void> {
  await page.click(on('editor'));
  await page.keyboard.press('ControlOrMeta+a');
  await page.keyboard.press('Delete');
  for (let count = 1; !isOver(); count += 1) {
    await page.keyboard.type(`x${String(count)}=0`, { delay: KEY_MS });
    await page.keyboard.press('Enter');
    if (!isOver()) done.push({ count, atMs: performance.now() });
    if (pauses && count % 4 === 0) await sleep(200 + Math.random() * 900);
  }
}

/** How far to the right each place of the pen is from the one before, in px. */
const STEP_PX = 1;

/** Draws one line that never ends, up and down and always a little to the right. */
async function draw(page: Page, done: Done, isOver: () => boolean): Promise<void> {
  await page.click(by('mode-build'));
  await page.click('[data-tool=pen]');
  await expect.poll(() => page.locator(by('arena')).evaluate((it) => it.style.cursor)).not.toBe('progress');
  const box = await page.locator(by('arena')).boundingBox();
  if (box === null) throw new Error('There is no arena.');
  const [x, y] = [box.x + box.width * 0.25, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let count = 1; !isOver(); count += 1) {
    await page.mouse.move(x + count * STEP_PX, y + (count % 2 === 0 ? 30 : -30), { steps: 3 });
    if (!isOver()) done.push({ count, atMs: performance.now() });
    await sleep(15);
  }
}

/** How long before its end the work that is found was done, in ms. */
async function missingIn(page: Page, manner: Manner, done: Done): Promise<number> {
  const endMs = done.at(-1)?.atMs ?? NaN;
  const found = manner === 'drawing' ? await drawn(page) : await typed(page);
  const next = done.find(({ count }) => count > found)?.atMs ?? endMs;
  return endMs - next;
}

/** The work that the page has opened, as it stands in the storage once it was saved. */
async function typed(page: Page): Promise<number> {
  await page.click(on('editor'));
  await page.keyboard.press('ControlOrMeta+End'); // a long program has only those lines that are in sight
  let last = NaN;
  const isStill = async (): Promise<boolean> => {
    const lines = await page.locator(`${on('editor')} .cm-line`).allTextContents();
    const before = last;
    last = Math.max(0, ...lines.map((line) => Number(/^\s*x(\d+)=0$/.exec(line)?.[1] ?? 0)));
    return last === before;
  };
  await expect.poll(isStill, { intervals: [600] }).toBe(true); // the editor scrolls there a moment later
  return last;
}

/** How many places the line has that was drawn: how far to the right it goes. */
async function drawn(page: Page): Promise<number> {
  await page.click(by('mode-drive'));
  await page.click(on('editor'));
  await page.keyboard.type('#'); // so that the opened work is saved
  await sleep(1500);
  const text = await page.evaluate(() => sessionStorage.getItem('parcours.work'));
  const { project } = JSON.parse(text ?? '') as { project: { scene: { size: Point; objects: Partial<Stroke>[] } } };
  const { size, objects } = project.scene;
  expect(objects.length, 'the line that was drawn, beside what the course has').toBe(
    sceneOf('missions/01-forward').objects.length + 1,
  );
  await page.click(by('mode-build')); // the course is as large as when it was drawn
  await page.waitForSelector('[data-tool]');
  const across = objects.at(-1)?.points?.map(([x]) => x) ?? [];
  const [left, right] = await inWindow(playwrightApp('chromium', page), size, [
    [Math.min(...across), 0],
    [Math.max(...across), 0],
  ]);
  return Math.round(((right?.x ?? NaN) - (left?.x ?? NaN)) / STEP_PX);
}

/** The process of the page ends at once, as out of memory. */
async function crash(page: Page): Promise<void> {
  const tools = await page.context().newCDPSession(page);
  const gone = page.waitForEvent('crash');
  tools.send('Page.crash').catch(() => undefined); // there is nobody left to answer
  await gone;
}

interface KillableBrowser {
  readonly context: BrowserContext;
  /** Ends all of its processes, without a word. */
  kill(): Promise<void>;
}

/** A browser with a profile that outlives it, in a group of processes of its own. */
async function startBrowser(profile: string): Promise<KillableBrowser> {
  const port = join(profile, 'DevToolsActivePort');
  await rm(port, { force: true });
  const child = spawn(
    process.env['PARCOURS_CHROMIUM'] ?? '/usr/bin/chromium',
    [
      ...['--headless', '--no-sandbox', '--no-first-run', '--remote-debugging-port=0', '--disable-audio-output'],
      ...['--window-size=1280,900', `--user-data-dir=${profile}`, 'about:blank'],
    ],
    { detached: true, stdio: 'ignore' },
  );
  const address = (): Promise<string> =>
    readFile(port, 'utf8').then(
      (text) => text.split('\n')[0] ?? '',
      () => '',
    );
  await expect.poll(address, { timeout: 30_000 }).not.toBe('');
  const browser = await chromium.connectOverCDP(`http://127.0.0.1:${await address()}`);
  const [context] = browser.contexts();
  if (context === undefined) throw new Error('The browser has no profile.');
  return { context, kill: () => killed(child) };
}

/** Kills the group of a process that was started here. */
async function killed(child: ChildProcess): Promise<void> {
  if (child.pid === undefined || child.exitCode !== null || child.signalCode !== null) return;
  const ended = new Promise((resolve) => child.once('exit', resolve));
  process.kill(-child.pid, 'SIGKILL');
  await ended;
}
