import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { convoyOf } from '#simulation/testing/convoy';
import type { LineEvent } from '#vm/debug/line-watch';
import { readVariables } from '#vm/debug/variables';
import { Looker } from './looker';
import type { FromLooker, Instant, Look, LookWish } from './protocol';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

const runOf = (main: string): RunSetup =>
  soloRun({
    scene: defaultScene(),
    files: { 'main.py': main },
    robot: 'maqueen-lite',
    board: 'microbit-v2',
    seed: 3,
    reality: 0.5,
  });

/** Every line that begins in a run, with its time. */
async function linesOf(setup: RunSetup, untilUs: number, device = 0) {
  const run = await Simulation.create(setup, firmware);
  const lines: (LineEvent & { readonly timeUs: number })[] = [];
  run.watch((event) => {
    if (event.kind === 'line') lines.push({ ...event, timeUs: run.timeOf(device) });
    return false;
  }, device);
  run.advanceTo(untilUs);
  return lines;
}

/** A worker that looks into a run, and answers one wish at a time. */
function lookerInto(setup: RunSetup) {
  let tell: (message: FromLooker) => void = () => undefined;
  const looker = new Looker({
    post: (message) => tell(message),
    nowMs: () => performance.now(),
    rest: () => new Promise((resolve) => setImmediate(resolve)),
  });
  looker.receive({ type: 'look-into', firmware, setup });
  let ask = 0;
  return (wish: LookWish): Promise<Look | null> =>
    new Promise((resolve, reject) => {
      ask += 1;
      tell = (message) => {
        if (message.type === 'look-failed') reject(new Error(message.message));
        else if (message.ask === ask) resolve(message.look);
      };
      looker.receive({ type: 'look', ask, wish });
    });
}

const PROGRAM = `from mbrobot import *
def turn(n):
    for i in range(n):
        left()
        delay(20)
count = 0
while count < 8:
    forward()
    delay(100)
    turn(3)
    count += 1
`;
const at = (timeUs: number, isLine = false, device = 0): Instant => ({ device, timeUs, isLine });

describe('looking into a run that has been', { timeout: 60_000 }, () => {
  it('goes back line by line to the start, as the lines came', async () => {
    const setup = runOf(PROGRAM);
    const lines = await linesOf(setup, 900_000);
    const look = lookerInto(setup);
    let from = at(900_000);
    for (const line of lines.reverse()) {
      const found = await look({ kind: 'back', at: from });
      expect([found?.timeUs, found?.variables.stack[0]?.line]).toEqual([line.timeUs, line.line]);
      from = at(found?.timeUs ?? 0, true);
    }
    expect(await look({ kind: 'back', at: from })).toBeNull();
  });

  it('shows the variables and the robot of a moment as they were', async () => {
    const setup = runOf(PROGRAM);
    const look = lookerInto(setup);
    for (const timeUs of [700_000, 300_000, 320_000, 20_000]) {
      const run = await Simulation.create(setup, firmware);
      run.advanceTo(timeUs);
      const found = await look({ kind: 'moment', at: at(timeUs) });
      expect(found?.variables).toEqual(readVariables(run.inspect()!));
      expect(found?.snapshot).toEqual(run.snapshot());
    }
  });

  it('steps on from a moment, over, into and out of functions, until the run has come no further', async () => {
    const setup = runOf(PROGRAM);
    const look = lookerInto(setup);
    const untilUs = 900_000;
    const lines: (number | undefined)[] = [];
    let from = at(50_000);
    for (const step of ['over', 'into', 'into', 'out', 'over', 'over', { file: 'main.py', line: 5 }] as const) {
      const found = await look({ kind: 'step', at: from, step, untilUs });
      lines.push(found?.variables.stack[0]?.line);
      from = found ?? from;
    }
    expect(lines).toEqual([10, 3, 4, 10, 11, 7, 5]);
    expect(await look({ kind: 'step', at: from, step: { file: 'main.py', line: 99 }, untilUs })).toBeNull();
  });

  it('goes to the line of an error with its variables, also when a finally came after it', async () => {
    const setup = runOf(
      'def half(n):\n    try:\n        return 10 // n\n    finally:\n        n = "gone"\nx = 1\nhalf(x - 1)',
    );
    const run = await Simulation.create(setup, firmware);
    run.advanceTo(2_000_000);
    const { ended } = run;
    const wish = { kind: 'error', at: at(ended!.timeUs), line: ended!.exception!.line } as const;
    const found = await lookerInto(setup)(wish);
    expect(found?.variables.stack).toMatchObject([
      { function: 'half', line: 3, locals: [{ name: 'n', value: { text: '0' } }] },
      { function: '<module>', line: 7 },
    ]);
  });

  it('finds the line before a long sleep, and before a busy second', async () => {
    for (const main of [
      'from microbit import *\nx = 1\nsleep(3000)\nx = 2\nsleep(6000)\nx = 3\nsleep(100)',
      'i = 0\nwhile True:\n    i += 1\n',
    ]) {
      const setup = runOf(main);
      const untilUs = main.startsWith('i') ? 1_000_000 : 9_050_000;
      const lines = (await linesOf(setup, untilUs)).slice(-4).reverse();
      const look = lookerInto(setup);
      let from = at(untilUs);
      for (const line of lines) {
        const found = await look({ kind: 'back', at: from });
        expect([found?.timeUs, found?.variables.stack[0]?.line]).toEqual([line.timeUs, line.line]);
        from = at(found?.timeUs ?? 0, true);
      }
    }
  });

  it.each([0, 2])('does so with device %i of three', async (device) => {
    const setup = convoyOf(3);
    const lines = (await linesOf(setup, 600_000, device)).slice(-30);
    const look = lookerInto(setup);
    let from = at(600_000, false, device);
    const after = lines.at(-1)!;
    const last = await look({ kind: 'back', at: from });
    expect(Math.abs((last?.timeUs ?? 0) - after.timeUs)).toBeLessThan(8_000);
    from = at(lines.at(-1)!.timeUs, true, device);
    for (const line of lines.reverse().slice(1)) {
      const found = await look({ kind: 'back', at: from });
      expect([found?.timeUs, found?.variables.stack[0]?.line]).toEqual([line.timeUs, line.line]);
      from = at(found?.timeUs ?? 0, true, device);
    }
    const on = await look({ kind: 'step', at: from, step: 'into', untilUs: 600_000 });
    expect(on?.timeUs).toBeGreaterThan(from.timeUs);
  });
});
