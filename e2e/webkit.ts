import { spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';

/** The key under which WebDriver hands out an element (W3C WebDriver §12.1). */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';
const SCRIPT_TIMEOUT_MS = 60_000;
const FIND_TIMEOUT_MS = 20_000;
const START_TIMEOUT_MS = 20_000;

/** Code for the page: a function of one argument, or the text of an expression. */
export type PageCode<A, R> = string | ((argument: A) => R | Promise<R>);

interface Answer {
  readonly value: unknown;
}

/** WebKitGTK's compositor aborts now and then where there is no graphics card. No test is about it: Safari has another one. */
const WITHOUT_COMPOSITOR = { WEBKIT_DISABLE_COMPOSITING_MODE: '1' };

/** A browser window of Debian's WebKitGTK, driven over WebDriver. Every session starts with empty storage. */
export class WebKitSession {
  private constructor(
    private readonly driver: ChildProcess,
    private readonly address: string,
  ) {}

  /** Starts a driver of its own and opens a window. @throws Error when the driver does not answer within 20 s */
  static async start(): Promise<WebKitSession> {
    const port = await freePort();
    const driver = spawn(process.env['PARCOURS_WEBKIT_DRIVER'] ?? 'WebKitWebDriver', [`--port=${port}`], {
      env: { ...process.env, ...WITHOUT_COMPOSITOR },
      stdio: 'ignore',
      detached: true, // its own process group, so that close() also ends the windows it opened
    });
    const service = `http://127.0.0.1:${port}`;
    await untilReady(service);
    const options = { binary: process.env['PARCOURS_WEBKIT'], args: ['--automation'] };
    const capabilities = { alwaysMatch: { browserName: 'MiniBrowser', 'webkitgtk:browserOptions': options } };
    const opened = (await send(service, 'POST', '/session', { capabilities })) as { sessionId: string };
    const session = new WebKitSession(driver, `${service}/session/${opened.sessionId}`);
    await session.command('POST', '/timeouts', { script: SCRIPT_TIMEOUT_MS, pageLoad: 30_000 });
    return session;
  }

  async goto(url: string): Promise<void> {
    await this.command('POST', '/url', { url });
  }

  async reload(): Promise<void> {
    await this.command('POST', '/refresh', {});
  }

  /** Runs code in the page and waits for what it promises. @throws Error with the page's own message */
  async evaluate<R, A = null>(code: PageCode<A, R>, argument?: A): Promise<R> {
    const called = typeof code === 'string' ? `(async () => (${code}))` : `(${String(code)})`;
    const script = `const [argument, done] = arguments;
      Promise.resolve().then(() => ${called}(argument))
        .then((value) => done({ value }), (error) => done({ error: String(error?.stack ?? error) }));`;
    const answer = await this.command('POST', '/execute/async', { args: [argument ?? null], script });
    const { value, error } = answer as { value?: R; error?: string };
    if (error !== undefined) throw new Error(error);
    return value as R;
  }

  /** The same in the page of a frame. */
  async inFrame<R, A = null>(frame: string, code: PageCode<A, R>, argument?: A): Promise<R> {
    await this.command('POST', '/frame', { id: { [ELEMENT]: await this.find(frame) } });
    try {
      return await this.evaluate(code, argument);
    } finally {
      await this.command('POST', '/frame', { id: null });
    }
  }

  /**
   * Clicks the middle of an element, as Playwright does: scrolls it into the window, waits until it stands still, is
   * enabled and uncovered, and clicks again where the press went beside it because the page moved in between.
   * @throws Error when it could not be hit within 20 s
   */
  async click(css: string): Promise<void> {
    await this.retried(async () => {
      const middle = await this.evaluate(readyToBeHit, css);
      if (typeof middle === 'string') throw new Error(`${css} ${middle}.`);
      await this.mouse([
        { type: 'pointerMove', origin: 'viewport', ...middle, duration: 0 },
        { type: 'pointerDown', button: 0 },
        { type: 'pointerUp', button: 0 },
      ]);
      if (!(await this.evaluate(wasHit))) throw new Error(`The click on ${css} missed it.`);
    });
  }

  /** Replaces the text of an input. */
  async fill(css: string, text: string): Promise<void> {
    const element = await this.find(css);
    await this.command('POST', `/element/${element}/clear`, {});
    await this.command('POST', `/element/${element}/value`, { text });
  }

  /** As Playwright reads it; the driver's own reading leaves out what ends in an ellipsis. */
  async text(css: string): Promise<string> {
    await this.find(css);
    return this.evaluate((selector) => document.querySelector<HTMLElement>(selector)?.innerText.trim() ?? '', css);
  }

  /** Presses keys together: characters, or WebDriver's code points for named keys. */
  async press(keys: readonly string[]): Promise<void> {
    const down = keys.map((value) => ({ type: 'keyDown', value }));
    const up = keys.map((value) => ({ type: 'keyUp', value })).reverse();
    await this.strokes([...down, ...up]);
  }

  /** Types characters one after the other into whatever has the focus. */
  type(text: string): Promise<void> {
    return this.strike(Array.from(text));
  }

  /** Presses keys one after the other. */
  strike(keys: readonly string[]): Promise<void> {
    return this.strokes(
      keys.flatMap((value) => [
        { type: 'keyDown', value },
        { type: 'keyUp', value },
      ]),
    );
  }

  /** A key goes down and stays so: the driver remembers it from one command to the next. */
  async hold(key: string): Promise<void> {
    await this.strokes([{ type: 'keyDown', value: key }]);
  }

  async release(key: string): Promise<void> {
    await this.strokes([{ type: 'keyUp', value: key }]);
  }

  /** Presses the mouse on the middle of an element and keeps it down. In a drawing WebDriver itself finds no middle. */
  async grab(css: string): Promise<void> {
    await this.find(css);
    const middle = await this.evaluate((selector: string) => {
      const box = document.querySelector(selector)?.getBoundingClientRect() ?? new DOMRect();
      return { x: Math.round(box.x + box.width / 2), y: Math.round(box.y + box.height / 2) };
    }, css);
    await this.mouse([
      { type: 'pointerMove', origin: 'viewport', ...middle, duration: 0 },
      { type: 'pointerDown', button: 0 },
    ]);
  }

  async letGo(): Promise<void> {
    await this.mouse([{ type: 'pointerUp', button: 0 }]);
  }

  /** Draws with the mouse through places of the window, in CSS px. */
  async draw(places: readonly { readonly x: number; readonly y: number }[], button = 0): Promise<void> {
    const moves = places.map(({ x, y }) => ({
      type: 'pointerMove',
      origin: 'viewport',
      x: Math.round(x),
      y: Math.round(y),
      duration: 10,
    }));
    const [first, ...others] = moves;
    if (first === undefined) return;
    await this.mouse([first, { type: 'pointerDown', button }, ...others, { type: 'pointerUp', button }]);
  }

  /** Lets go of whatever is held, and moves the mouse into the corner. */
  async restHand(): Promise<void> {
    await this.command('DELETE', '/actions');
    await this.mouse([{ type: 'pointerMove', origin: 'viewport', x: 0, y: 0, duration: 0 }]);
  }

  async screenshot(): Promise<Buffer> {
    return Buffer.from((await this.command('GET', '/screenshot')) as string, 'base64');
  }

  /** Sets the window's size; the page is a tool bar (38 px) lower. */
  async resize(width: number, height: number): Promise<void> {
    await this.command('POST', '/window/rect', { width, height: height + 38 });
  }

  /** Closes the window and ends the driver. */
  async close(): Promise<void> {
    await this.command('DELETE', '').catch(() => undefined);
    if (this.driver.pid !== undefined && this.driver.exitCode === null) process.kill(-this.driver.pid);
  }

  private command(method: string, path: string, body?: unknown): Promise<unknown> {
    return send(this.address, method, path, body);
  }

  private async strokes(actions: readonly { readonly type: string; readonly value: string }[]): Promise<void> {
    if (actions.length > 0)
      await this.command('POST', '/actions', { actions: [{ type: 'key', id: 'keyboard', actions }] });
  }

  private async mouse(actions: readonly object[]): Promise<void> {
    const source = { type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions };
    await this.command('POST', '/actions', { actions: [source] });
  }

  private find(css: string): Promise<string> {
    return this.retried(async () => {
      const found = await this.command('POST', '/element', { using: 'css selector', value: css });
      return (found as Record<string, string>)[ELEMENT] ?? '';
    });
  }

  /** Tries again while the element is not there or not yet to be touched. */
  private async retried<R>(attempt: () => Promise<R>): Promise<R> {
    for (const started = Date.now(); ;) {
      try {
        return await attempt();
      } catch (error) {
        if (Date.now() - started > FIND_TIMEOUT_MS) throw error;
        await sleep(50);
      }
    }
  }
}

/** The page's memory between aiming at an element and pressing it. */
interface Aimed {
  aimedAt?: { hit: boolean | null };
}

/**
 * Waits until an element can be hit, and listens where the next press goes. Runs in the page.
 *
 * @returns the middle of the element in CSS px of the window, or why it cannot be hit
 */
async function readyToBeHit(css: string): Promise<{ x: number; y: number } | string> {
  let before = '';
  let problem = 'is not there';
  for (let look = 0; look < 40; look += 1) {
    await frames();
    const element = document.querySelector(css);
    if (!element) continue;
    if (look % 4 === 0) element.scrollIntoView({ block: look % 8 ? 'center' : 'nearest', behavior: 'instant' });
    const { x: left, y: top, width, height } = element.getBoundingClientRect();
    const [x, y] = [Math.floor(left + width / 2), Math.floor(top + height / 2)];
    const now = [left, top, width, height].join();
    const hit = document.elementFromPoint(x, y);
    if (element.matches(':disabled')) problem = 'is disabled';
    else if (!hit || !element.contains(hit)) problem = `is covered by ${hit?.outerHTML.slice(0, 100) ?? 'the edge'}`;
    else if (now !== before || glides(element)) problem = 'does not stand still';
    else return aim(x, y);
    before = now;
  }
  return problem;

  /** Two frames; in a window that draws none for a while, no longer than 100 ms. */
  async function frames() {
    const drawn = new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    await Promise.race([drawn, new Promise((done) => setTimeout(done, 100))]);
  }

  /** Whether it, or what it lies in, is on its way in or out: a menu that has not begun to move stands still as well. */
  function glides(element: Element): boolean {
    if (element.closest('[class*="-enter-"], [class*="-leave-"]') !== null) return true;
    return document.getAnimations().some(({ effect }) => {
      if (!(effect instanceof KeyframeEffect) || effect.getComputedTiming().endTime === Infinity) return false;
      return effect.target?.contains(element) ?? false;
    });
  }

  function aim(x: number, y: number) {
    const aimed: { hit: boolean | null } = { hit: null };
    (window as Aimed).aimedAt = aimed;
    const press = (event: Event) => {
      const target = event.composedPath()[0];
      aimed.hit = target instanceof Element && target.closest(css) !== null;
    };
    window.addEventListener('pointerdown', press, { capture: true, once: true });
    return { x, y };
  }
}

/** True if the press went to the element; a page that is new since then was left by it. Runs in the page. */
async function wasHit(): Promise<boolean> {
  const aimed = (window as Aimed).aimedAt;
  for (let look = 0; aimed?.hit === null && look < 30; look += 1) await new Promise((done) => setTimeout(done, 10));
  return aimed?.hit ?? aimed === undefined;
}

async function send(base: string, method: string, path: string, body?: unknown): Promise<unknown> {
  const response = await fetch(base + path, { method, ...(body !== undefined && { body: JSON.stringify(body) }) });
  const { value } = (await response.json()) as Answer;
  const problem = value as { error?: string; message?: string } | null;
  if (!response.ok) throw new Error(`${problem?.error ?? response.status}: ${problem?.message ?? path}`);
  return value;
}

async function untilReady(service: string): Promise<void> {
  for (const started = Date.now(); ;) {
    try {
      await fetch(`${service}/status`);
      return;
    } catch (error) {
      if (Date.now() - started > START_TIMEOUT_MS) throw error;
      await sleep(25);
    }
  }
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const address = server.address();
  server.close();
  if (address === null || typeof address === 'string') throw new Error('No port for the WebKit driver.');
  return address.port;
}
