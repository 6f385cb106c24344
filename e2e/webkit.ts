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

  async click(css: string): Promise<void> {
    await this.find(css);
    await this.canBeHit(css);
    await this.retried(async () => {
      await this.command('POST', `/element/${await this.find(css)}/click`, {});
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
  async draw(places: readonly { readonly x: number; readonly y: number }[]): Promise<void> {
    const moves = places.map(({ x, y }) => ({
      type: 'pointerMove',
      origin: 'viewport',
      x: Math.round(x),
      y: Math.round(y),
      duration: 10,
    }));
    const [first, ...others] = moves;
    if (first === undefined) return;
    await this.mouse([first, { type: 'pointerDown', button: 0 }, ...others, { type: 'pointerUp', button: 0 }]);
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

  /** Waits, as Playwright does, until an element no longer moves and can be hit: a menu that glides in cannot. */
  private canBeHit(css: string): Promise<void> {
    return this.evaluate(async (selector: string) => {
      const element = document.querySelector(selector);
      if (element === null) return;
      let before = '';
      for (let look = 0; look < 60; look += 1) {
        const { x, y, width, height } = element.getBoundingClientRect();
        const now = [x, y, width, height].join();
        const hit = document.elementFromPoint(x + width / 2, y + height / 2);
        if (now === before && (hit === null || element.contains(hit))) return; // null: beyond the window
        before = now;
        await new Promise((done) => setTimeout(done, 32)); // frames stand still in a window that is covered
      }
    }, css);
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
