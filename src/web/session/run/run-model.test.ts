import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { defaultScene } from '#scene/scene';

import type { InputEvent } from '#simulation/input';
import type { Snapshot } from '#simulation/snapshot';
import type { FromWorker, RunEvents, ToWorker } from './worker/protocol';
import type { WorkerPort } from './run-client';
import { goOn } from './run-again';
import { RunModel, type RunHost } from './run-model';
import { soloRun } from '#simulation/run-setup';

/** A worker that answers as ours does, a moment later. */
class QuickWorker implements WorkerPort {
  static readonly sent: ToWorker[] = [];
  onmessage: WorkerPort['onmessage'] = null;
  onerror: WorkerPort['onerror'] = null;
  postMessage(message: ToWorker): void {
    const { type } = message;
    QuickWorker.sent.push(message);
    const answer = { prepare: 'prepared', run: 'started', stop: 'stopped' }[type as string];
    if (answer !== undefined) setTimeout(() => this.say({ type: answer } as FromWorker));
  }
  terminate(): void {
    this.onmessage = null;
  }
  say(data: FromWorker): void {
    this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }
}

const nothing = (): void => undefined;
const newRun = (host: Partial<RunHost> = {}): RunModel =>
  new RunModel({
    createWorker: () => new QuickWorker(),
    firmware: () => Promise.resolve({} as WebAssembly.Module),
    setup: (kept) =>
      kept ??
      soloRun({
        scene: defaultScene(),
        files: { 'main.py': '' },
        ...{ robot: 'auto', board: 'auto', seed: 1, reality: 0 },
      }),
    ...{ onInput: nothing, onStart: nothing, onOutput: nothing, onEnded: nothing, onRestarted: nothing },
    ...{ onEvents: nothing, onUnavailable: nothing, onFailed: nothing, onRefused: nothing, onKilled: nothing },
    ...host,
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

  it('runs if it is started in the same breath: the start came last', async () => {
    const run = newRun();
    void run.reset();
    void run.start();
    await aMoment();
    expect(run.phase.value).toBe('running');
  });

  it('runs, too, if it is started while the run before is being stopped', async () => {
    const run = newRun();
    await run.start();
    await aMoment();
    void run.reset();
    expect(run.phase.value).toBe('stopping');
    void run.start();
    await vi.waitFor(() => expect(run.phase.value).toBe('running'));
    await run.reset();
    expect(run.phase.value).toBe('ready');
  });

  it('is at its start when both are done if it is being stopped', async () => {
    const run = newRun();
    await run.start();
    await aMoment();
    void run.stop();
    await run.reset();
    expect(run.phase.value).toBe('ready');
    await aMoment();
    expect(run.phase.value).toBe('ready');
  });
});

describe('a run whose VM is on its way', () => {
  beforeEach(() => {
    vi.stubGlobal('requestAnimationFrame', () => 0);
    vi.stubGlobal('cancelAnimationFrame', nothing);
    QuickWorker.sent.length = 0;
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });
  const serial = (text: string) => ({ type: 'serial', text }) as const;
  const inputs = () => QuickWorker.sent.flatMap((message) => (message.type === 'input' ? [message.action] : []));

  it('is given what is typed meanwhile, also in the moment of the start', async () => {
    const run: RunModel = newRun({ onStart: () => run.input(serial('first')) });
    void run.start();
    run.input(serial('second'));
    await aMoment();
    expect(inputs()).toEqual([serial('first'), serial('second')]);
  });

  it('is not given what was typed for the one before, which was stopped', async () => {
    const run = newRun();
    void run.start();
    run.input(serial('old'));
    await run.stop();
    expect(run.phase.value).toBe('stopped');
    void run.start();
    run.input(serial('new'));
    await aMoment();
    expect(inputs()).toEqual([serial('new')]);
  });

  it('is stopped at once although it never comes', async () => {
    const run = newRun({ firmware: () => new Promise(nothing) });
    void run.start();
    await run.stop();
    expect(run.phase.value).toBe('stopped');
  });

  it('does not begin where it is stopped by who hears of its start', async () => {
    const run: RunModel = newRun({ onStart: () => void run.stop() });
    void run.start();
    await aMoment();
    expect(run.phase.value).toBe('stopped');
    expect(QuickWorker.sent.map(({ type }) => type)).not.toContain('run');
  });

  it('stands still after one step where step is pressed meanwhile, and has the speed that was chosen meanwhile', async () => {
    const run = newRun();
    void run.start();
    run.step();
    run.setSpeed(4);
    expect(run.phase.value).toBe('starting');
    await aMoment();
    expect(run.phase.value).toBe('paused');
    expect(QuickWorker.sent.map(({ type }) => type).slice(0, 4)).toEqual(['prepare', 'run', 'step', 'speed']);
  });

  it('has not failed where it was stopped before its VM failed', async () => {
    let fail = nothing;
    const told: string[] = [];
    const firmware = () => new Promise<WebAssembly.Module>((_, reject) => (fail = () => reject(new Error('offline'))));
    const run = newRun({ firmware, onUnavailable: () => told.push('unavailable') });
    void run.start();
    await run.stop();
    fail();
    await aMoment();
    expect([run.phase.value, told]).toEqual(['stopped', []]);
  });

  it('tells why its VM cannot be had', async () => {
    const told: unknown[] = [];
    const why = new Error('forbidden');
    const run = newRun({ firmware: () => Promise.reject(why), onUnavailable: (reason) => told.push(reason) });
    await run.start();
    expect([run.phase.value, told]).toEqual(['failed', [why]]);
  });

  it('tells that its VM lets wait for itself after ten seconds, and not of one that was stopped', async () => {
    vi.useFakeTimers();
    const told: string[] = [];
    const run = newRun({ firmware: () => new Promise(nothing), onSlow: () => told.push('slow') });
    void run.start();
    await vi.advanceTimersByTimeAsync(9_900);
    expect(told).toEqual([]);
    await vi.advanceTimersByTimeAsync(200);
    expect(told).toEqual(['slow']);
    void run.start();
    await run.stop();
    await vi.advanceTimersByTimeAsync(11_000);
    expect(told).toEqual(['slow']);
    vi.useRealTimers();
  });
});

describe('a run in which nothing happens any more', () => {
  let ask: (() => void) | null = null;
  beforeEach(() => {
    QuickWorker.sent.length = 0;
    vi.stubGlobal('requestAnimationFrame', (next: () => void) => {
      ask = next;
      return 1;
    });
    vi.stubGlobal('cancelAnimationFrame', () => (ask = null));
  });
  afterEach(() => void vi.unstubAllGlobals());

  it('is asked for no more pictures, until something is done to it', async () => {
    let worker: QuickWorker | null = null;
    const run = newRun({ createWorker: () => (worker ??= new QuickWorker()) });
    void run.start();
    await aMoment();
    expect(ask).not.toBeNull();
    (worker as QuickWorker | null)?.say({ type: 'resting' });
    expect(ask).toBeNull();
    run.input({ type: 'button', button: 'a', down: true });
    expect(ask).not.toBeNull();
    expect(QuickWorker.sent.at(-1)).toMatchObject({ type: 'input' });
  });
});

describe('a run that is looked back at', () => {
  beforeEach(() => {
    vi.stubGlobal('requestAnimationFrame', () => 0);
    vi.stubGlobal('cancelAnimationFrame', nothing);
    QuickWorker.sent.length = 0;
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });
  const workers: QuickWorker[] = [];
  const createWorker = (): QuickWorker => {
    const worker = new QuickWorker();
    workers.push(worker);
    return worker;
  };
  const shows = (timeUs: number): FromWorker => ({ type: 'snapshot', snapshot: { timeUs } as Snapshot, trails: [] });
  const press = (timeUs: number): InputEvent => ({ timeUs, action: { type: 'interrupt' } });
  /** A run at 3 s, with inputs at 1 and at 2 s. */
  async function atThreeSeconds(
    host: Partial<RunHost> = {},
  ): Promise<{ run: RunModel; say: (message: FromWorker) => void }> {
    workers.length = 0;
    const run = newRun({ createWorker, ...host });
    await run.start();
    await aMoment();
    const say = (message: FromWorker): void => workers.at(-2)?.say(message); // the last one waits for the next run
    say(shows(3_000_000));
    run.look.back();
    say({ type: 'inputs', inputs: [press(1_000_000), press(2_000_000)], nowUs: 2_000_000 });
    return { run, say };
  }

  it('stands still, and shows the moment that is looked at until something is done', async () => {
    const { run } = await atThreeSeconds();
    expect(run.phase.value).toBe('paused');
    run.look.at(1_500_000, { timeUs: 1_500_000 } as Snapshot);
    expect(run.nowUs.value).toBe(1_500_000);
    run.input({ type: 'interrupt' });
    expect(run.nowUs.value).toBe(3_000_000);
  });

  it('goes on from one of its moments with what was done until then, silently until it is there', async () => {
    const heard: number[] = [];
    const { run, say } = await atThreeSeconds({ onEvents: ({ sound }) => heard.push(sound.length) });
    run.look.at(1_500_000, { timeUs: 1_500_000 } as Snapshot);
    await goOn(run, 1_500_000);
    await aMoment();
    const last = QuickWorker.sent.findLast((message) => message.type === 'run');
    expect(last).toMatchObject({ catchUpUs: 1_500_000, paused: false, setup: { inputs: [press(1_000_000)] } });
    const events = { sound: [{}], log: [], radio: [], radioDropped: 0 } as unknown as RunEvents;
    say(shows(200_000));
    say({ type: 'events', events, device: 0 });
    expect([run.nowUs.value, heard]).toEqual([1_500_000, [0]]);
    say(shows(1_504_000));
    say({ type: 'events', events, device: 0 });
    expect([run.nowUs.value, heard]).toEqual([1_504_000, [0, 1]]);
  });

  it('goes on from its very beginning at once', async () => {
    const { run } = await atThreeSeconds();
    run.look.at(0, { timeUs: 0 } as Snapshot);
    await goOn(run, 0);
    expect(run.past.value).toBeNull();
    await aMoment(); // its next worker is there
  });

  it('has the run that was left as its ghost, until another run begins', async () => {
    const { run } = await atThreeSeconds();
    const left = run.recording.value;
    await goOn(run, 1_500_000);
    expect([run.recording.value === left, run.recording.value.ghost.value === left]).toEqual([false, true]);
    await run.reset();
    expect(run.recording.value.ghost.value).toBeNull();
  });
});
