import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

import type { FromWorker } from './protocol';
import { Runner } from './runner';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const WAIT = 'while True: pass';

/**
 * Runs a program for some ms and stops it. @param lookMs cost of a look at the wall clock while it is being stopped:
 * high on a slow machine. @returns its output
 */
async function printedUntilStopped(program: string, { runMs = 40, lookMs = 1 } = {}): Promise<string> {
  let wallMs = 0;
  let costMs = 0.05;
  const posted: FromWorker[] = [];
  const tasks: { task: () => void; atMs: number }[] = [];
  const runner = new Runner({
    post: (message) => posted.push(message),
    nowMs: () => (wallMs += costMs),
    later: (task, delayMs) => tasks.push({ task, atMs: wallMs + delayMs }),
    create: (...given) => Simulation.create(...given),
  });
  const hardware = { robot: 'none', board: 'auto', seed: 1, reality: 0, repl: 'at-once' } as const;
  runner.receive({ type: 'prepare', firmware });
  const setup = soloRun({ scene: defaultScene(), files: { 'main.py': program }, ...hardware });
  runner.receive({ type: 'run', setup, speed: 1, paused: false });
  while (tasks.length === 0) await Promise.resolve();
  for (let next = tasks.shift(); next !== undefined && wallMs < runMs; next = tasks.shift()) {
    wallMs = Math.max(wallMs, next.atMs);
    next.task();
    runner.receive({ type: 'console-taken' });
  }
  costMs = lookMs;
  runner.receive({ type: 'stop' });
  expect(posted.at(-1)).toEqual({ type: 'stopped' });
  return posted
    .map((message) => (message.type === 'console' ? message.output.map(({ text }) => text).join('') : ''))
    .join('');
}

describe('a program that is stopped', { timeout: 60_000 }, () => {
  it.each([
    ['computes', WAIT],
    ['sleeps', 'from microbit import *\nwhile True: sleep(1000)'],
    ['scrolls', 'from microbit import *\ndisplay.scroll("hello", loop=True, wait=True)'],
    ['is deep in functions', `def f(n):\n  if n: f(n - 1)\n  ${WAIT}\nf(20)`],
    ['waits for a name', 'input()'],
    ['talks by wire', `from microbit import *\nuart.init(9600, tx=pin0, rx=pin1)\n${WAIT}`],
  ])('shows no traceback where it %s, also on a slow machine', async (_, program) => {
    for (const lookMs of [1, 18, 26]) expect(await printedUntilStopped(program, { lookMs })).toBe('');
  });

  it('shows what it printed, and at last what its finally prints', async () => {
    const program = `print("hi")\ntry:\n  ${WAIT}\nfinally:\n  print("bye")`;
    for (const lookMs of [1, 18]) expect(await printedUntilStopped(program, { lookMs })).toBe('hi\nbye\n');
  });

  it('shows the error that it makes meanwhile: that is none of the stop', async () => {
    const printed = await printedUntilStopped(`try:\n  ${WAIT}\nfinally:\n  x = y`);
    expect(printed).toContain('line 4');
    expect(printed).toContain("NameError: name 'y' isn't defined\n");
    expect(printed).not.toContain('KeyboardInterrupt');
  });
});
