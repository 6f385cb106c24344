import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { versionLock } from './versions';

const SCOPE = 'https://school.example/app/';
const OLD = `${SCOPE}assets/index-OLD.js`;
const NEW = `${SCOPE}assets/index-NEW.js`;

/** Read so because its types are those of a service worker, not of a page. */
const [load] = Object.values(import.meta.glob('./sw.ts'));

/** The browser's cache: what is in it, by address. */
class Cache {
  readonly kept = new Map<string, Response>();
  private readonly addressOf = (what: string | Request) => (typeof what === 'string' ? what : what.url);
  match(what: string | Request): Promise<Response | undefined> {
    return Promise.resolve(this.kept.get(this.addressOf(what))?.clone());
  }
  put(what: string | Request, response: Response): Promise<void> {
    return Promise.resolve(void this.kept.set(this.addressOf(what), response));
  }
  delete(what: string | Request): Promise<boolean> {
    return Promise.resolve(this.kept.delete(this.addressOf(what)));
  }
  keys(): Promise<readonly Request[]> {
    return Promise.resolve([...this.kept.keys()].map((address) => new Request(address)));
  }
}

/** An event of a service worker. */
class Happening {}

/** A browser with the service worker of the new version, whose files a server has. */
async function browser() {
  const cache = new Cache();
  const listeners = new Map<string, (event: object) => void>();
  const asked: string[] = [];
  const server = new Map<string, () => Response>([
    [`${SCOPE}index.html`, () => new Response('the new page')],
    [NEW, () => new Response('the new script')],
  ]);
  const fetched = (what: string | Request): Promise<Response> => {
    const address = (typeof what === 'string' ? what : what.url).split('?')[0] ?? '';
    asked.push(address);
    return Promise.resolve(server.get(address)?.() ?? new Response('', { status: 404 }));
  };
  const pages: object[] = [];
  const held: string[] = [];
  const claim = vi.fn(() => Promise.resolve());
  const skipWaiting = vi.fn(() => Promise.resolve());
  const registration = { scope: SCOPE, installing: null as object | null, waiting: null as object | null };
  const locks = {
    request: (_name: string, act: () => unknown) => Promise.resolve(act()),
    query: () => Promise.resolve({ held: held.map((name) => ({ name })) }),
  };
  const caches = { open: () => Promise.resolve(cache), match: (what: string | Request) => cache.match(what) };
  const self = {
    caches,
    __WB_MANIFEST: [
      { url: 'index.html', revision: '2' },
      { url: 'assets/index-NEW.js', revision: null },
    ],
    __WB_DISABLE_DEV_LOGS: true,
    addEventListener: (name: string, act: (event: object) => void) => listeners.set(name, act),
    ...{ registration, skipWaiting, clients: { claim, matchAll: () => Promise.resolve(pages) } },
  };
  vi.stubGlobal('self', self);
  vi.stubGlobal('__WB_DISABLE_DEV_LOGS', true);
  vi.stubGlobal('FetchEvent', class {});
  vi.stubGlobal('ExtendableEvent', Happening);
  vi.stubGlobal('registration', registration);
  vi.stubGlobal('location', new URL(`${SCOPE}sw.js`));
  vi.stubGlobal('caches', caches);
  vi.stubGlobal('fetch', fetched);
  vi.stubGlobal('navigator', { locks });
  await load?.();

  /** Something happens to the worker; waits for all that it does about it. */
  async function happens(name: string, event: object = {}): Promise<void> {
    const work: Promise<unknown>[] = [];
    const waitUntil = (promise: Promise<unknown>) => void work.push(promise);
    listeners.get(name)?.(Object.assign(new Happening(), { type: name, waitUntil }, event));
    await Promise.all(work);
  }
  /** The response that a page gets for this address: a text, or `null` if the worker leaves it to the browser. */
  async function get(address: string, how: { mode?: string; method?: string } = {}): Promise<string | null> {
    const request = Object.assign(new Request(address, { method: how.method ?? 'GET' }));
    Object.defineProperty(request, 'mode', { value: how.mode ?? 'no-cors' });
    const answers: Promise<Response>[] = [];
    listeners.get('fetch')?.({ request, respondWith: (answer: Promise<Response>) => void answers.push(answer) });
    return answers[0] === undefined ? null : (await answers[0]).text();
  }
  const kept = () => [...cache.kept.keys()].map((address) => address.split('?')[0]).sort();
  return { cache, server, asked, pages, held, registration, claim, skipWaiting, happens, get, kept };
}

beforeEach(() => void vi.resetModules());
afterEach(() => void vi.unstubAllGlobals());

describe('the service worker, when it is installed', () => {
  it('fetches every file of its version, and keeps them', async () => {
    const { happens, kept, asked } = await browser();
    await happens('install');
    expect(asked).toEqual([`${SCOPE}index.html`, NEW]);
    expect(kept()).toEqual([NEW, `${SCOPE}index.html`]);
  });

  it('rests for 25 ms before each file, so that a robot that drives meanwhile keeps its frames', async () => {
    const { happens, asked } = await browser();
    const rests: { ms: number | undefined; fetched: number }[] = [];
    vi.stubGlobal('setTimeout', (goOn: () => void, ms?: number) => {
      if (ms !== 0) rests.push({ ms, fetched: asked.length }); // 0: Workbox lets others in between
      goOn();
    });
    await happens('install');
    expect(rests).toEqual([
      { ms: 25, fetched: 0 },
      { ms: 25, fetched: 1 },
    ]);
  });

  it('fails as a whole when one file cannot be had: the version before stays', async () => {
    const { happens, server } = await browser();
    server.delete(NEW);
    await expect(happens('install')).rejects.toMatchObject({ name: 'bad-precaching-response' });
  });

  it('does not fetch again what the first try has brought', async () => {
    const { happens, server, asked } = await browser();
    server.delete(NEW);
    await happens('install').catch(() => undefined);
    asked.length = 0;
    server.set(NEW, () => new Response('the new script'));
    await happens('install');
    expect(asked).toEqual([NEW]);
  });

  it('serves the page that was there first, too', async () => {
    const { happens, claim } = await browser();
    await happens('activate');
    expect(claim).toHaveBeenCalledOnce();
  });

  it('takes over only when the pupil wants it', async () => {
    const { happens, skipWaiting } = await browser();
    await happens('install');
    await happens('message', { data: 'take-over' });
    expect(skipWaiting).not.toHaveBeenCalled();
    await happens('message', { data: { type: 'take-over' } });
    expect(skipWaiting).toHaveBeenCalledOnce();
  });
});

describe('the service worker, when a page wants something', () => {
  async function installed() {
    const all = await browser();
    await all.happens('install');
    all.asked.length = 0;
    return all;
  }

  it('has its files without the network', async () => {
    const { get, asked } = await installed();
    expect(await get(NEW)).toBe('the new script');
    expect(asked).toEqual([]);
  });

  it('has the page itself, whatever its address asks of it', async () => {
    const { get, asked } = await installed();
    for (const address of ['', 'index.html', '?lang=fr&task=slalom', 'index.html?show=board'])
      expect(await get(SCOPE + address, { mode: 'navigate' })).toBe('the new page');
    expect(asked).toEqual([]);
  });

  it('fetches a file that belongs to another version, and has it where that version was kept', async () => {
    const { get, server, cache, asked } = await installed();
    server.set(OLD, () => new Response('from the network'));
    expect(await get(OLD)).toBe('from the network');
    await cache.put(OLD, new Response('kept'));
    expect(await get(OLD)).toBe('kept');
    expect(asked).toEqual([OLD]);
  });

  it('leaves to the browser what is none of its files', async () => {
    const { get } = await installed();
    expect(await get(`${SCOPE}manual.pdf`, { mode: 'navigate' })).toBeNull();
    expect(await get('https://other.example/app/index.html')).toBeNull();
    expect(await get(`${SCOPE}index.html`, { method: 'POST' })).toBeNull();
  });
});

describe('the service worker, when it is asked to tidy up', () => {
  const tidy = { data: { type: 'tidy' } };
  /** The new version is installed beside files of the old one; so many pages of these versions are open. */
  async function afterUpdate(...open: readonly string[]) {
    const all = await browser();
    await all.happens('install');
    await all.cache.put(OLD, new Response('the old script'));
    for (const entry of open) {
      all.pages.push({});
      all.held.push(versionLock(entry));
    }
    return all;
  }

  it('gives up the files of earlier versions, and none of its own', async () => {
    const { happens, kept } = await afterUpdate(NEW, NEW);
    await happens('message', tidy);
    expect(kept()).not.toContain(OLD);
    expect(kept()).toEqual(expect.arrayContaining([NEW, `${SCOPE}index.html`]));
  });

  it('keeps them as long as one page of an earlier version is open', async () => {
    const { happens, kept, held, pages } = await afterUpdate(NEW, OLD);
    await happens('message', tidy);
    expect(kept()).toContain(OLD);
    held.pop();
    pages.pop();
    await happens('message', tidy);
    expect(kept()).not.toContain(OLD);
  });

  it('keeps them while a page has not said its version yet', async () => {
    const { happens, kept, pages } = await afterUpdate(NEW);
    pages.push({});
    await happens('message', tidy);
    expect(kept()).toContain(OLD);
  });

  it.each(['installing', 'waiting'] as const)(
    'keeps everything while a version is %s: its files are there already',
    async (state) => {
      const { happens, kept, registration } = await afterUpdate(NEW);
      registration[state] = {};
      await happens('message', tidy);
      expect(kept()).toContain(OLD);
    },
  );

  it('does so once: what comes later belongs to a version to come', async () => {
    const { happens, kept, cache } = await afterUpdate(NEW);
    await happens('message', tidy);
    await cache.put(`${SCOPE}assets/index-NEXT.js`, new Response('the next script'));
    await happens('message', tidy);
    expect(kept()).toContain(`${SCOPE}assets/index-NEXT.js`);
  });
});
