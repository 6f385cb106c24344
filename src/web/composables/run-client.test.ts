import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import type { RunSetup } from '#simulation/run-setup';

import type { FromWorker, ToWorker } from '../worker/protocol';
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
        onerror: null,
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
  return { client, workers, heard, say, types, killed: () => killed };
}

describe('the page’s end of a run', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('has a worker ready before the first run and uses it', async () => {
    const b = bench();
    await b.client.warmUp();
    expect(b.types(0)).toEqual(['prepare']);
    await b.client.start(setup, 1, false);
    expect(b.types(0)).toEqual(['prepare', 'run']);
    expect(b.workers).toHaveLength(1);
  });

  it('takes a fresh worker for every run and ends the old one', async () => {
    const b = bench();
    await b.client.start(setup, 1, false);
    await b.client.start(setup, 1, false);
    expect(b.workers).toHaveLength(2);
    expect(b.workers[0]!.ended).toBe(true);
  });

  it('stops by asking when the worker answers', async () => {
    const b = bench();
    await b.client.start(setup, 1, false);
    expect(await b.client.stop()).toBe('stopped');
    expect(b.workers[0]!.ended).toBe(true);
    expect(b.killed()).toBe(0);
  });

  it('ends a worker by force 0.5 s after an unanswered stop', async () => {
    const b = bench(false);
    await b.client.start(setup, 1, false);
    const stopping = b.client.stop();
    vi.advanceTimersByTime(499);
    expect(b.workers[0]!.ended).toBe(false);
    vi.advanceTimersByTime(1);
    expect(await stopping).toBe('killed');
    expect(b.workers[0]!.ended).toBe(true);
    expect(b.killed()).toBe(1);
  });

  it('no longer listens to a worker it has dropped', async () => {
    const b = bench();
    await b.client.start(setup, 1, false);
    const { onmessage } = b.workers[0]!;
    await b.client.start(setup, 1, false);
    onmessage?.({ data: { type: 'console', text: 'late' } } as MessageEvent<FromWorker>);
    expect(b.heard).toEqual([]);
  });

  it('does not start a run that was stopped while the VM was loading', async () => {
    const b = bench();
    const starting = b.client.start(setup, 1, false);
    await b.client.stop();
    await starting;
    expect(b.types(0)).toEqual(['prepare']);
  });
});
