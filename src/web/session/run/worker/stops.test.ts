import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { convoyOf } from '#simulation/testing/convoy';
import type { FromWorker, ToWorker } from './protocol';
import { Runner } from './runner';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

const PROGRAM = `from mbrobot import *
def turn(n):
    for i in range(n):
        left()
        delay(20)
count = 0
while count < 5:
    forward()
    delay(30)
    turn(3)
    count += 1
    print(count)
`;
const drive = soloRun({
  scene: defaultScene(),
  files: { 'main.py': PROGRAM },
  robot: 'maqueen-lite',
  board: 'microbit-v2',
  seed: 3,
  reality: 0.5,
});

/** A run in the worker, whose messages are answered by `answer`. */
function inWorker(
  setup: RunSetup,
  answer: (message: FromWorker, send: (message: ToWorker) => void) => void,
  turnMs = 4,
) {
  let wallMs = 0;
  const tasks: (() => void)[] = [];
  let made: Simulation | null = null;
  const printed: string[] = [];
  const runner: Runner = new Runner({
    post(message) {
      if (message.type === 'console') {
        printed.push(...message.output.map(({ text }) => text));
        tasks.push(() => runner.receive({ type: 'console-taken' }));
      }
      answer(message, (each) => tasks.push(() => runner.receive(each)));
    },
    nowMs: () => wallMs,
    later: (task) => tasks.push(task),
    create: async (...given) => (made = await Simulation.create(...given)),
  });
  runner.receive({ type: 'prepare', firmware });
  return {
    receive: (message: ToWorker) => runner.receive(message),
    /** Lets wall time pass until the run has reached a time. */
    async until(us: number): Promise<void> {
      runner.receive({ type: 'run', setup, speed: 1, paused: false });
      while (made === null) await Promise.resolve();
      await Promise.resolve();
      for (let turns = 0; made.nowUs < us && turns < 100_000; turns++) {
        wallMs += turnMs;
        tasks.shift()?.();
      }
    },
    outcome() {
      if (made === null) throw new Error('There is no run.');
      const { nowUs, traceHash, inputLog } = made;
      return { nowUs, traceHash, inputLog, free: setup.devices.map((_, place) => made?.heapFree(place)), printed };
    },
  };
}

const UNTIL_US = 1_500_000;

async function undisturbed(setup: RunSetup) {
  const run = inWorker(setup, () => undefined);
  await run.until(UNTIL_US);
  return run.outcome();
}

describe('break points and steps in the worker', { timeout: 60_000 }, () => {
  it('stop the run at their lines, tell the variables, and leave it the run that it is', async () => {
    const seen: string[] = [];
    const run = inWorker(drive, (message, send) => {
      if (message.type === 'held') send({ type: 'inspect', device: message.device });
      if (message.type !== 'variables') return;
      const { stack, globals } = message.variables;
      seen.push(`${stack[0]?.line ?? 0}: ${globals.find(({ name }) => name === 'count')?.value.text ?? ''}`);
      send({ type: 'resume' });
    });
    run.receive({ type: 'break-points', points: [[{ file: 'main.py', line: 12 }]] });
    await run.until(UNTIL_US);
    expect(seen).toEqual(['12: 1', '12: 2', '12: 3', '12: 4', '12: 5']);
    const { nowUs: _, ...outcome } = run.outcome();
    expect(outcome).toMatchObject(withoutTime(await undisturbed(drive)));
  });

  it('go over, into and out of functions, and up to a line', async () => {
    const steps = ['over', 'over', 'into', 'out', { file: 'main.py', line: 11 }, 'over'] as const;
    const lines: (number | undefined)[] = [];
    const run = inWorker(drive, (message, send) => {
      if (message.type === 'snapshot') lines.push(message.snapshot.position?.line);
      if (message.type !== 'held') return;
      const step = steps[lines.length - 1];
      send(step ? { type: 'step-line', step, device: 0 } : { type: 'resume' });
    });
    run.receive({ type: 'break-points', points: [[{ file: 'main.py', line: 8 }]] });
    await run.until(150_000);
    expect(lines.slice(0, 7)).toEqual([8, 9, 10, 3, 10, 11, 12]);
  });

  it('stop when the lines begin in the run again, whatever the wall clock says meanwhile', async () => {
    const begun = new Set<string>();
    const again = await Simulation.create(drive, firmware);
    again.watch((event) => {
      if (event.kind === 'line') begun.add(`${String(event.line)} at ${String(again.timeOf(0))}`);
      return false;
    });
    again.advanceTo(UNTIL_US);
    const held: string[] = [];
    let line: number | undefined;
    const run = inWorker(
      drive,
      (message, send) => {
        if (message.type === 'snapshot') line = message.snapshot.position?.line;
        if (message.type !== 'held') return;
        held.push(`${String(line)} at ${String(message.timeUs)}`);
        send({ type: 'step-line', step: 'into', device: 0 });
      },
      0.0137,
    );
    run.receive({ type: 'break-points', points: [[{ file: 'main.py', line: 6 }]] });
    await run.until(60_000);
    expect(held.length).toBeGreaterThan(8);
    expect(held.filter((moment) => !begun.has(moment))).toEqual([]);
  });

  it('stop whichever device they belong to, and are forgotten when they are taken away', async () => {
    const setup = convoyOf(3);
    const held: number[] = [];
    const run = inWorker(setup, (message, send) => {
      if (message.type !== 'held') return;
      held.push(message.device);
      if (held.length < 3) return send({ type: 'step-line', step: 'over', device: message.device });
      send({ type: 'break-points', points: [] });
      send({ type: 'resume' });
    });
    const points = Array.from({ length: 12 }, (_, line) => ({ file: 'main.py', line }));
    run.receive({ type: 'break-points', points: [[], [], points] });
    await run.until(UNTIL_US);
    expect(held).toEqual([2, 2, 2]);
    expect(withoutTime(run.outcome())).toEqual(withoutTime(await undisturbed(setup)));
  });
});

/** Two runs that continue until the same time end their last pieces differently. */
const withoutTime = <T extends { nowUs: number }>({ nowUs: _, ...rest }: T) => rest;
