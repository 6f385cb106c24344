import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { defaultScene } from '#scene/scene';

import type { FromWorker, ToWorker } from '../worker/protocol';
import type { WorkerPort } from './run-client';
import { RunModel } from './use-run';

/** A worker that answers as ours does, a moment later. */
class QuickWorker implements WorkerPort {
  onmessage: WorkerPort['onmessage'] = null;
  onerror: WorkerPort['onerror'] = null;
  postMessage({ type }: ToWorker): void {
    const answer = { prepare: 'prepared', run: 'started', stop: 'stopped' }[type as string];
    if (answer !== undefined) setTimeout(() => this.say({ type: answer } as FromWorker));
  }
  terminate(): void {
    this.onmessage = null;
  }
  private say(data: FromWorker): void {
    this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }
}

const nothing = (): void => undefined;
const newRun = (): RunModel =>
  new RunModel({
    createWorker: () => new QuickWorker(),
    firmware: () => Promise.resolve({} as WebAssembly.Module),
    setup: () => ({
      scene: defaultScene(),
      files: { 'main.py': '' },
      ...{ robot: 'auto', board: 'auto', seed: 1, reality: 0 },
    }),
    ...{ onInput: nothing, onStart: nothing, onOutput: nothing, onEnded: nothing, onRestarted: nothing },
    ...{ onEvents: nothing, onUnavailable: nothing, onFailed: nothing, onRefused: nothing, onKilled: nothing },
  });
const aMoment = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 20));

describe('a run that is put back to its start', () => {
  beforeEach(() => {
    vi.stubGlobal('requestAnimationFrame', () => 0);
    vi.stubGlobal('cancelAnimationFrame', nothing);
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  it('and started in the same breath runs: the start came last', async () => {
    const run = newRun();
    void run.reset();
    void run.start();
    await aMoment();
    expect(run.phase.value).toBe('running');
  });

  it('and started while the run before is being stopped runs, too', async () => {
    const run = newRun();
    await run.start();
    await aMoment();
    void run.reset();
    expect(run.phase.value).toBe('stopping');
    void run.start();
    await aMoment();
    expect(run.phase.value).toBe('running');
    await run.reset();
    expect(run.phase.value).toBe('ready');
  });
});
