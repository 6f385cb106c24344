import { readFile } from 'node:fs/promises';

import { afterEach, describe, expect, it, vi } from 'vitest';

import { projectToText } from '#project/file';
import { defaultScene } from '#scene/scene';

import type { Adapter } from '../adapter';
import { createParcoursAdapter } from '../parcours/adapter';
import { RecordingSimulator } from '../testing/recording-simulator';
import { connect, ParcoursError } from './connect';
import type { ConnectOptions } from './types';

const project = { files: [{ name: 'main.py', text: 'print(1)' }], scene: defaultScene(), course: null };
const ends: (() => void)[] = [];
afterEach(() => {
  for (const end of ends.splice(0)) end();
});

/** A page behind a port, which can be loaded anew. */
function pageBehindPort({ isThere = true } = {}) {
  const { port1, port2 } = new MessageChannel();
  let adapter: Adapter | null = null;
  let simulator = new RecordingSimulator();
  let loads = 0;
  const load = (): void => {
    loads += 1;
    simulator = new RecordingSimulator();
    const connection = { post: (message: object) => port2.postMessage(message), nowMs: () => 0 };
    const facts = { app: '0.1.0', page: `page ${String(loads)}`, devices: [], robots: [], courses: [] };
    adapter = createParcoursAdapter(simulator, connection, facts);
  };
  port2.onmessage = ({ data }) => adapter?.receive(data);
  if (isThere) load();
  ends.push(() => {
    port1.close();
    port2.close();
  });
  return { port: port1, load, simulator: () => simulator };
}

async function connected(options: ConnectOptions = {}) {
  const page = pageBehindPort();
  const parcours = await connect(page.port, options);
  ends.push(() => parcours.close());
  return { page, parcours };
}

const quiet = () => new Promise((resolve) => setTimeout(resolve, 30));

describe('the client for host pages', () => {
  it('connects, sends what is asked for and gives back the answers', async () => {
    const { page, parcours } = await connected();
    expect(parcours.welcome).toMatchObject({ app: '0.1.0', page: 'page 1' });
    expect(Object.keys(parcours.welcome)).toEqual(['versions', 'app', 'page', 'abilities']);
    await parcours.setProject(projectToText(project));
    expect(await parcours.getProject()).toMatchObject(JSON.parse(projectToText(project)) as object);
    await parcours.setSpeed('max');
    await parcours.run();
    expect(await parcours.getState()).toMatchObject({ phase: 'running', speed: 'max' });
    await parcours.press('a', true);
    await parcours.radio(Uint8Array.of(1, 2));
    expect(page.simulator().calls.slice(-2)).toEqual([
      { call: 'input', action: { type: 'button', button: 'a', down: true } },
      { call: 'input', action: { type: 'radio', bytes: [1, 2] } },
    ]);
  });

  it('rejects what the page refuses, with its reason', async () => {
    const { parcours } = await connected();
    await expect(parcours.pause()).rejects.toMatchObject({ name: 'ParcoursError', code: 'refused' });
    await expect(parcours.setSeed(-1)).rejects.toMatchObject({ code: 'wrong-message', path: 'seed' });
    await expect(parcours.setSeed(-1)).rejects.toBeInstanceOf(ParcoursError);
  });

  it('has each of its methods with its arguments in the README of its package', async () => {
    const { parcours } = await connected();
    const readme = await readFile('packages/client/README.md', 'utf8');
    const told = [...readme.matchAll(/^\| `(\w+)\(([^`]*)\)`/gm)].map(([, name]) => name ?? '');
    const methods = Object.entries(Object.getOwnPropertyDescriptors(parcours))
      .filter(([, { value }]) => typeof value === 'function')
      .map(([name]) => name);
    expect(methods.length).toBeGreaterThan(30);
    expect(told.sort()).toEqual([...methods, 'connect'].sort());
  });

  it('has one kind of error, whichever package brings its class', () => {
    class ParcoursErrorOfThePackage extends Error {
      override readonly name = 'ParcoursError';
    }
    expect(new ParcoursErrorOfThePackage('no') instanceof ParcoursError).toBe(true);
    expect(new TypeError('no') instanceof ParcoursError).toBe(false);
    expect({ name: 'ParcoursError' } instanceof ParcoursError).toBe(false);
  });

  it('tells events until nobody listens any more', async () => {
    const { page, parcours } = await connected();
    const heard: object[] = [];
    const end = parcours.on('output', (data) => heard.push(data));
    page.simulator().tell({ type: 'output', text: 'one' });
    await quiet();
    end();
    page.simulator().tell({ type: 'output', text: 'two' });
    await quiet();
    expect(heard).toEqual([{ text: 'one' }]);
  });

  it('repeats hello until a page that loads late is there', async () => {
    const page = pageBehindPort({ isThere: false });
    const connecting = connect(page.port, { timeoutMs: 20_000 });
    setTimeout(page.load, 300);
    const parcours = await connecting;
    expect(parcours.welcome.page).toBe('page 1');
    parcours.close();
  });

  it('takes no answer to another client of the same page for its own', async () => {
    const { port1, port2 } = new MessageChannel();
    const asked: { readonly id: unknown; readonly type: string }[] = [];
    port2.onmessage = ({ data }: MessageEvent<(typeof asked)[number]>) => {
      asked.push(data);
      if (data.type === 'hello') port2.postMessage({ parcours: 1, reply: data.id, ok: true, page: 'p' });
      // The answer to another client with the same count of ids.
      else for (const reply of [1, 2, 3]) port2.postMessage({ parcours: 1, reply, ok: true });
    };
    const parcours = await connect(port1, { commandTimeoutMs: 100 });
    ends.push(() => parcours.close());
    await expect(parcours.stop()).rejects.toMatchObject({ code: 'timeout' });
    expect(new Set(asked.map(({ id }) => id)).size).toBe(asked.length);
  });

  it('gives up after the time it was given', async () => {
    const page = pageBehindPort({ isThere: false });
    await expect(connect(page.port, { timeoutMs: 50 })).rejects.toMatchObject({ code: 'timeout' });
  });

  it('notices that the page was loaded anew, subscribes again and says so', async () => {
    const { page, parcours } = await connected({ subscribe: { snapshotHz: 60, events: ['snapshot', 'started'] } });
    const restarted = vi.fn();
    parcours.on('restarted', restarted);
    page.load();
    await expect(parcours.getState()).rejects.toMatchObject({ code: 'restarted' });
    await vi.waitFor(() => expect(restarted).toHaveBeenCalledOnce());
    expect(restarted.mock.calls[0]?.[0]).toMatchObject({ page: 'page 2' });
    const heard: object[] = [];
    parcours.on('snapshot', (data) => heard.push(data));
    parcours.on('output', (data) => heard.push(data));
    await parcours.run();
    page.simulator().tell({ type: 'output', text: 'not wanted' });
    page.simulator().tell({ type: 'snapshot', snapshot: page.simulator().snapshot()! });
    await quiet();
    expect(heard).toEqual([{ snapshot: expect.objectContaining({ running: 'program' }) }]);
  });

  it('does not connect with a wish that the page refuses, and forgets one that it refuses later', async () => {
    const page = pageBehindPort();
    const wrong = { subscribe: { snapshotHz: NaN } };
    await expect(connect(page.port, wrong)).rejects.toMatchObject({ code: 'wrong-message', path: 'snapshotHz' });
    const { page: other, parcours } = await connected({ subscribe: { snapshotHz: 60 } });
    await expect(parcours.subscribe({ snapshotHz: -1 })).rejects.toMatchObject({ code: 'wrong-message' });
    const restarted = vi.fn();
    parcours.on('restarted', restarted);
    other.load();
    await expect(parcours.getState()).rejects.toMatchObject({ code: 'restarted' });
    await vi.waitFor(() => expect(restarted).toHaveBeenCalledOnce());
    const heard: object[] = [];
    parcours.on('snapshot', (data) => heard.push(data));
    await parcours.run();
    other.simulator().tell({ type: 'snapshot', snapshot: other.simulator().snapshot()! });
    await quiet();
    expect(heard.length).toBe(1);
  });

  it('sends what a framework has wrapped, and says when something cannot be sent', async () => {
    const { page, parcours } = await connected();
    const wrapped = new Proxy([{ name: 'main.py', text: 'a = 1' }], {});
    await parcours.setFiles(wrapped);
    expect(page.simulator().project().files).toEqual([{ name: 'main.py', text: 'a = 1' }]);
    const own: { self?: object } = {};
    own.self = new Proxy(own, {});
    await expect(parcours.setScene(own as never)).rejects.toMatchObject({ code: 'not-plain' });
  });

  it('rejects everything that waits when it is closed, and says bye', async () => {
    const { page, parcours } = await connected();
    const waiting = parcours.run();
    parcours.close();
    await expect(waiting).rejects.toMatchObject({ code: 'closed' });
    await expect(parcours.stop()).rejects.toMatchObject({ code: 'closed' });
    await vi.waitFor(() => expect(page.simulator().listenerCount).toBe(0));
  });

  it('takes whatever a page says that is not what it should be, and throws nowhere but in answers', async () => {
    const { port1, port2 } = new MessageChannel();
    port2.onmessage = ({ data }: MessageEvent<{ id: number }>) =>
      port2.postMessage({ parcours: 1, reply: data.id, ok: false, code: {}, message: { toString: 1, valueOf: 1 } });
    ends.push(() => port1.close());
    await expect(connect(port1)).rejects.toThrow(ParcoursError);
  });
});
