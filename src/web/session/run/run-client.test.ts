import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import type { RunSetup } from '#simulation/run-setup';

import type { FromWorker, ToWorker } from './worker/protocol';
import { RunClient, type WorkerPort } from './run-client';

const setup = {} as RunSetup;

function bench(answersStop = true) {
  const workers: (WorkerPort & { sent: ToWorker[]; ended: boolean })[] = [];
  const heard: FromWorker[] = [];
  let killed = 0;
  const client = new RunClient({
    createWorker() {
      const worker = {
        sent: [] as ToWorker[],
        ended: false,
        onmessage: null as WorkerPort['onmessage'],
        onerror: null as WorkerPort['onerror'],
        postMessage(message: ToWorker) {
          worker.sent.push(message);
          if (message.type === 'stop' && answersStop) say(worker, { type: 'stopped' });
        },
        terminate: () => (worker.ended = true),
      };
      workers.push(worker);
      return worker;
    },
    firmware: () => Promise.resolve({} as WebAssembly.Module),
    onMessage: (message) => heard.push(message),
    onKilled: () => (killed += 1),
  });
  const say = (worker: WorkerPort, data: FromWorker): void => worker.onmessage?.({ data } as MessageEvent<FromWorker>);
  const types = (index: number): string[] => workers[index]!.sent.map((message) => message.type);
  const ends: FromWorker[] = [];
  const start = (): Promise<void> => {
    client.expect((message) => ends.push(message));
    return client.start(setup, { speed: 1, paused: false });
  };
  /** A run that has begun. */
  const begin = async (): Promise<void> => {
    await start();
    say(workers.at(-1)!, { type: 'started' });
    heard.length = 0;
  };
  return { client, start, begin, workers, heard, ends, say, types, killed: () => killed };
}

describe('the page’s end of a run', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('has a worker ready before the first run and uses it', async () => {
    const b = bench();
    await b.client.warmUp();
    expect(b.types(0)).toEqual(['prepare']);
    await b.start();
    expect(b.types(0)).toEqual(['prepare', 'run']);
    expect(b.workers).toHaveLength(1);
  });

  it('takes a fresh worker for every run and ends the old one', async () => {
    const b = bench();
    await b.start();
    await b.start();
    expect(b.workers).toHaveLength(2);
    expect(b.workers[0]!.ended).toBe(true);
  });

  it('hears the end of the tape of a run that another one follows, for 0.3 s at most', async () => {
    const b = bench();
    await b.begin();
    await b.start();
    expect([b.types(0).slice(2), b.workers[0]!.ended]).toEqual([['tape'], false]);
    const end: readonly FromWorker[] = [
      { type: 'tape', piece: new Uint8Array(1), thinSinceUs: null },
      { type: 'inputs', inputs: [], nowUs: 1 },
    ];
    for (const message of end) b.say(b.workers[0]!, message);
    expect([b.ends, b.heard, b.workers[0]!.ended]).toEqual([end, [], true]);
    b.say(b.workers[1]!, { type: 'started' });
    await b.start();
    vi.advanceTimersByTime(299);
    expect(b.workers[1]!.ended).toBe(false);
    vi.advanceTimersByTime(1);
    expect(b.workers[1]!.ended).toBe(true);
  });

  it('stops by asking when the worker answers', async () => {
    const b = bench();
    await b.begin();
    expect(await b.client.stop()).toBe('stopped');
    expect(b.workers[0]!.ended).toBe(true);
    expect(b.killed()).toBe(0);
  });

  it('ends a worker by force 0.5 s after an unanswered stop', async () => {
    const b = bench(false);
    await b.begin();
    const stopping = b.client.stop();
    vi.advanceTimersByTime(499);
    expect(b.workers[0]!.ended).toBe(false);
    vi.advanceTimersByTime(1);
    expect(await stopping).toBe('killed');
    expect(b.workers[0]!.ended).toBe(true);
    expect(b.killed()).toBe(1);
  });

  it('ends one that has not begun at once, without asking', async () => {
    const b = bench(false);
    await b.start();
    expect(await b.client.stop()).toBe('stopped');
    expect([b.workers[0]!.ended, b.types(0), b.killed()]).toEqual([true, ['prepare', 'run'], 0]);
  });

  it('no longer listens to a worker it has dropped', async () => {
    const b = bench();
    await b.start();
    const { onmessage } = b.workers[0]!;
    await b.start();
    const late: FromWorker = { type: 'console', output: [{ device: 0, text: 'late', timeUs: 0 }] };
    onmessage?.({ data: late } as MessageEvent<FromWorker>);
    expect(b.heard).toEqual([]);
  });

  it('does not start a run that was stopped while the VM was loading', async () => {
    const b = bench();
    const starting = b.start();
    await b.client.stop();
    await starting;
    expect(b.types(0)).toEqual(['prepare']);
  });

  it('gives a run, when its VM has come, what was done before, in order', async () => {
    const b = bench();
    const starting = b.start();
    for (const text of ['one', 'two']) b.client.send({ type: 'input', action: { type: 'serial', text } });
    expect(b.types(0)).toEqual([]);
    await starting;
    b.client.send({ type: 'pause' });
    expect(b.types(0)).toEqual(['prepare', 'run', 'input', 'input', 'pause']);
    expect(b.workers[0]!.sent[2]).toEqual({ type: 'input', action: { type: 'serial', text: 'one' } });
  });

  it('forgets what was done before a run that is stopped while the VM is loading', async () => {
    const b = bench();
    const starting = b.start();
    b.client.send({ type: 'input', action: { type: 'interrupt' } });
    await b.client.stop();
    await starting;
    await b.start();
    expect(b.types(0)).toEqual(['prepare', 'run']);
  });

  it('keeps a thousand things that are done before and says which are too many', async () => {
    const b = bench();
    const starting = b.start();
    const taken = Array.from({ length: 1001 }, () => b.client.send({ type: 'input', action: { type: 'interrupt' } }));
    expect(taken.filter((isTaken) => !isTaken)).toHaveLength(1);
    await starting;
    expect(b.types(0)).toHaveLength(1002);
  });

  it('takes another worker where the code of the one that stood ready could not be loaded', async () => {
    const b = bench();
    await b.client.warmUp();
    b.workers[0]!.onerror?.({ message: '' } as ErrorEvent);
    expect(b.workers[0]!.ended).toBe(true);
    await b.start();
    expect(b.types(1)).toEqual(['prepare', 'run']);
  });

  it('says that the worker could not be loaded where the browser gives no reason', async () => {
    const b = bench();
    await b.start();
    b.workers[0]!.onerror?.({ message: '' } as ErrorEvent);
    expect(b.heard).toEqual([{ type: 'failed', message: 'The worker could not be loaded.' }]);
  });
});
