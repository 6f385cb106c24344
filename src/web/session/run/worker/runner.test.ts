import { describe, expect, it } from 'vitest';

import type { RunOutlets } from '#simulation/outlets';
import type { RunSetup } from '#simulation/run-setup';
import type { Ended } from '#simulation/simulation';

import type { Snapshot } from '#simulation/snapshot';
import type { FromWorker, ToWorker } from './protocol';
import { Runner, type Run } from './runner';

/** A run whose simulated time costs `costMs` of wall time per simulated ms, printing `perMs` characters in each. */
function bench(
  options: {
    costMs?: number;
    perMs?: number;
    endsAtUs?: number;
    minds?: boolean;
    inputError?: Error;
    idle?: boolean;
  } = {},
) {
  let wallMs = 0;
  const posted: FromWorker[] = [];
  const tasks: { task: () => void; atMs: number }[] = [];
  const run = {
    nowUs: 0,
    heldBy: null,
    ended: null as Ended | null,
    isIdle: options.idle === true,
    print: (() => undefined) as NonNullable<RunOutlets['print']>,
    get endings() {
      return [run.ended];
    },
    get hasEnded() {
      return run.ended !== null;
    },
    inputs: [] as unknown[],
    inputLog: [],
    disposed: false,
    advanceTo(us: number) {
      wallMs += ((us - run.nowUs) / 1000) * (options.costMs ?? 0.01);
      const printed = 'x'.repeat(Math.round(((us - run.nowUs) / 1000) * (options.perMs ?? 0)));
      if (run.ended === null && printed !== '') run.print(printed, 0);
      run.nowUs = us;
      if (us >= (options.endsAtUs ?? Infinity)) run.ended ??= { kind: 'finished', exception: null, timeUs: us };
    },
    advanceProgramTo(us: number) {
      run.advanceTo(Math.min(us, Math.max(run.nowUs, options.endsAtUs ?? Infinity)));
    },
    input(action: unknown) {
      if (options.inputError !== undefined) throw options.inputError;
      run.inputs.push({ action, timeUs: run.nowUs });
    },
    stop() {
      if (options.minds !== false) run.ended = { kind: 'exception', exception: null, timeUs: run.nowUs };
    },
    snapshot: () => ({ timeUs: run.nowUs }) as Snapshot,
    dispose: () => (run.disposed = true),
  };
  const runner = new Runner({
    post: (message) => posted.push(message),
    nowMs: () => wallMs,
    later: (task, delayMs) => tasks.push({ task, atMs: wallMs + delayMs }),
    create: (_setup, _firmware, { print }) => {
      if (print !== undefined) run.print = print;
      return Promise.resolve(run as unknown as Run);
    },
  });
  let taken = 0;
  const types = (): string[] => posted.map((message) => message.type);
  const send = (message: ToWorker): void => runner.receive(message);
  /** Lets wall time pass; the page takes console batches immediately when `takes`. */
  async function pass(ms: number, takes = true): Promise<void> {
    await Promise.resolve();
    const untilMs = wallMs + ms;
    for (let rounds = 0; rounds < 10_000; rounds += 1) {
      const next = tasks.sort((a, b) => a.atMs - b.atMs)[0];
      if (next === undefined || next.atMs > untilMs || wallMs > untilMs) break;
      tasks.shift();
      wallMs = Math.max(wallMs, next.atMs);
      next.task();
      for (; takes && taken < types().filter((type) => type === 'console').length; taken += 1) {
        send({ type: 'console-taken' });
      }
    }
    wallMs = Math.max(wallMs, untilMs);
  }
  async function start(speed: 1 | 2 | 'max' = 1, paused = false): Promise<void> {
    send({ type: 'prepare', firmware: {} });
    send({ type: 'run', setup: { devices: [{}] } as unknown as RunSetup, speed, paused });
    await Promise.resolve();
    await Promise.resolve();
  }
  return { run, send, pass, start, posted, types };
}

describe('the runner', () => {
  it('lets a second of simulated time pass in a second, and two at double speed', async () => {
    for (const speed of [1, 2] as const) {
      const b = bench();
      await b.start(speed);
      await b.pass(1000);
      expect(b.run.nowUs / 1e6).toBeCloseTo(speed, 1);
    }
  });

  it('runs on without rest at full speed, yet looks at messages every 8 ms', async () => {
    const b = bench({ costMs: 0.1 });
    await b.start('max');
    await b.pass(100);
    expect(b.run.nowUs / 1000).toBeGreaterThan(900);
    b.send({ type: 'pause' });
    const { nowUs } = b.run;
    await b.pass(100);
    expect(b.run.nowUs).toBe(nowUs);
  });

  it('catches up with a moment as fast as it can, also paused, and then goes at its pace', async () => {
    const b = bench();
    b.send({ type: 'prepare', firmware: {} });
    b.send({
      type: 'run',
      setup: { devices: [{}] } as unknown as RunSetup,
      speed: 1,
      paused: false,
      catchUpUs: 5_000_000,
    });
    await b.pass(100);
    expect(b.run.nowUs / 1e6).toBeCloseTo(5, 0);
    await b.pass(1000);
    expect(b.run.nowUs / 1e6).toBeCloseTo(6, 0);
    b.send({ type: 'tape' });
    expect(b.posted.at(-1)).toMatchObject({ type: 'inputs', inputs: [] });
  });

  it('stands still while paused and moves 20 ms per step', async () => {
    const b = bench();
    await b.start(1, true);
    await b.pass(100);
    expect(b.run.nowUs).toBe(0);
    b.send({ type: 'step' });
    b.send({ type: 'step' });
    await b.pass(100);
    expect(b.run.nowUs).toBe(40_000);
  });

  it('tells the factor reached when the machine is too slow', async () => {
    const b = bench({ costMs: 2 });
    await b.start();
    await b.pass(3000);
    const alive = b.posted.filter((message) => message.type === 'alive').at(-1);
    expect(alive?.type === 'alive' ? alive.achieved : null).toBeCloseTo(0.5, 1);
  });

  it('answers a frame with one snapshot, and only when something has moved', async () => {
    const b = bench();
    await b.start(1, true);
    b.send({ type: 'frame' });
    await b.pass(50);
    expect(b.types().filter((type) => type === 'snapshot')).toHaveLength(1);
    b.send({ type: 'frame' });
    await b.pass(50);
    expect(b.types().filter((type) => type === 'snapshot')).toHaveLength(1);
    b.send({ type: 'step' });
    await b.pass(50);
    expect(b.types().filter((type) => type === 'snapshot')).toHaveLength(2);
  });

  it('leaves out an input that the run refuses, tells the page why and runs on', async () => {
    const b = bench({ inputError: new RangeError('There is no block "b7".') });
    await b.start();
    await b.pass(100);
    b.send({ type: 'input', action: { type: 'arena-senses', on: true } });
    const { nowUs } = b.run;
    await b.pass(100);
    expect(b.posted.filter(({ type }) => type === 'refused')).toEqual([
      { type: 'refused', message: 'There is no block "b7".' },
    ]);
    expect(b.types()).not.toContain('failed');
    expect(b.run.nowUs).toBeGreaterThan(nowUs);
  });

  it('ends the run when an input breaks it inside', async () => {
    const b = bench({ inputError: new TypeError('not a function') });
    await b.start();
    b.send({ type: 'input', action: { type: 'arena-senses', on: true } });
    expect(b.posted.at(-1)).toEqual({ type: 'failed', message: 'not a function' });
  });

  it('lets the program wait when the page does not take its output', async () => {
    const b = bench({ perMs: 1000 });
    await b.start('max');
    await b.pass(2000, false);
    expect(b.types().filter((type) => type === 'console')).toHaveLength(1);
    const { nowUs } = b.run;
    expect(nowUs).toBeLessThan(1e6);
    b.send({ type: 'console-taken' });
    await b.pass(100);
    expect(b.run.nowUs).toBeGreaterThan(nowUs);
  });

  it('lets the world go on at 1 × when a program has ended at full speed', async () => {
    const b = bench({ endsAtUs: 100_000 });
    await b.start('max');
    await b.pass(1000);
    expect(b.types()).toContain('program-ended');
    expect(b.run.nowUs / 1000).toBeGreaterThan(900);
    expect(b.run.nowUs / 1000).toBeLessThan(1200);
  });

  it('keeps another speed when the program has ended', async () => {
    const b = bench({ endsAtUs: 100_000 });
    await b.start(2);
    await b.pass(1000);
    expect(b.run.nowUs / 1e6).toBeCloseTo(2, 1);
  });

  it('rests once the program has ended, nothing is set for later and nothing has moved for half a second', async () => {
    for (const speed of [1, 'max'] as const) {
      const b = bench({ endsAtUs: 100_000, idle: true });
      await b.start(speed);
      await b.pass(1000);
      expect(b.types().slice(-2)).toEqual(['snapshot', 'resting']);
      const { nowUs } = b.run;
      const said = b.posted.length;
      await b.pass(10_000);
      expect(b.run.nowUs).toBe(nowUs);
      expect(b.posted).toHaveLength(said);
    }
  });

  it('goes on from there, not from later, when something is done, and rests again', async () => {
    const b = bench({ endsAtUs: 100_000, idle: true });
    await b.start();
    await b.pass(60_000);
    const { nowUs } = b.run;
    b.send({ type: 'input', action: { type: 'button', button: 'a', down: true } });
    await b.pass(200);
    expect((b.run.nowUs - nowUs) / 1000).toBeCloseTo(200, -2);
    expect(b.types().slice(-2)).not.toContain('resting');
    await b.pass(1000);
    expect(b.types().filter((type) => type === 'resting')).toHaveLength(2);
  });

  it('does not rest while something is set for later, nor while the program runs, nor while anything moves', async () => {
    const later = bench({ endsAtUs: 100_000 });
    const running = bench({ idle: true });
    const moving = bench({ endsAtUs: 100_000, idle: true });
    moving.run.snapshot = () =>
      ({ timeUs: moving.run.nowUs, movers: { fan: moving.run.nowUs } }) as unknown as Snapshot;
    for (const b of [later, running, moving]) {
      await b.start();
      await b.pass(3000);
      expect(b.types()).not.toContain('resting');
      expect(b.run.nowUs / 1e6).toBeCloseTo(3, 1);
    }
  });

  it('tells the end of the program after its output, and lets the world go on', async () => {
    const b = bench({ perMs: 10, endsAtUs: 100_000 });
    await b.start();
    await b.pass(500);
    const ended = b.types().indexOf('program-ended');
    expect(ended).toBeGreaterThan(b.types().indexOf('console'));
    expect(b.types()[ended - 1]).toBe('snapshot'); // how the program left the robot
    expect(b.run.nowUs).toBeGreaterThan(400_000);
  });

  it('stops with all output, a last picture and stopped', async () => {
    const b = bench({ perMs: 10 });
    await b.start();
    await b.pass(100);
    b.send({ type: 'stop' });
    expect(b.types().slice(-2)).toEqual(['snapshot', 'stopped']);
    expect(b.run.disposed).toBe(true);
  });

  it('does what was done while the run was being created, in order and at time 0', async () => {
    const b = bench();
    b.send({ type: 'prepare', firmware: {} });
    b.send({ type: 'run', setup: { devices: [{}] } as unknown as RunSetup, speed: 1, paused: false });
    const actions = [
      { type: 'serial', text: 'Ada\n' },
      { type: 'sensor', id: 'lightLevel', value: 9 },
    ] as const;
    for (const action of actions) b.send({ type: 'input', action });
    await b.pass(100);
    expect(b.run.inputs).toEqual(actions.map((action) => ({ action, timeUs: 0 })));
  });

  it('does nothing of it when that run is stopped before it is there', async () => {
    const b = bench();
    b.send({ type: 'prepare', firmware: {} });
    b.send({ type: 'run', setup: { devices: [{}] } as unknown as RunSetup, speed: 1, paused: false });
    b.send({ type: 'input', action: { type: 'serial', text: 'Ada\n' } });
    b.send({ type: 'stop' });
    await b.pass(100);
    expect(b.run.inputs).toEqual([]);
    expect(b.types().at(-1)).toBe('stopped');
  });

  it('gives a program that ignores the interrupt 50 ms, then drops it', async () => {
    const b = bench({ minds: false, costMs: 1 });
    await b.start();
    await b.pass(100);
    const { nowUs } = b.run;
    b.send({ type: 'stop' });
    expect(b.types().at(-1)).toBe('stopped');
    expect((b.run.nowUs - nowUs) / 1000).toBeLessThan(60);
  });

  it('stops a run that is still being created', async () => {
    const b = bench();
    b.send({ type: 'prepare', firmware: {} });
    b.send({ type: 'run', setup: { devices: [{}] } as unknown as RunSetup, speed: 1, paused: false });
    b.send({ type: 'stop' });
    await b.pass(10);
    expect(b.types().at(-1)).toBe('stopped');
  });

  it('reports an error inside as failed and does nothing more', async () => {
    const b = bench();
    await b.start();
    b.run.advanceTo = () => {
      throw new Error('broken');
    };
    await b.pass(100);
    expect(b.posted.at(-1)).toEqual({ type: 'failed', message: 'broken' });
  });
});
