import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import type { Cause } from '#simulation/causes/causes';
import { soloRun, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { convoyOf } from '#simulation/testing/convoy';
import type { LineEvent } from '#vm/debug/line-watch';
import { readVariables } from '#vm/debug/variables';
import { Looker } from './looker';
import type { FromLooker, Instant, Look, LookWish, ToLooker, WhyWish } from './protocol';

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
  const answer = (messageOf: (ask: number) => ToLooker): Promise<Exclude<FromLooker, { type: 'look-failed' }>> =>
    new Promise((resolve, reject) => {
      ask += 1;
      tell = (message) => {
        if (message.type === 'look-failed') reject(new Error(message.message));
        else if (message.ask === ask) resolve(message);
      };
      looker.receive(messageOf(ask));
    });
  const look = async (wish: LookWish): Promise<Look | null> => {
    const found = await answer((number) => ({ type: 'look', ask: number, wish }));
    return found.type === 'looked' ? found.look : null;
  };
  const why = async (wish: WhyWish): Promise<readonly Cause[]> => {
    const found = await answer((number) => ({ type: 'why', ask: number, wish }));
    return found.type === 'caused' ? found.causes : [];
  };
  return Object.assign(look, { why });
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

  it('goes back to the line before from the midst of one', async () => {
    const look = lookerInto(
      runOf('def wait():\n    x = 1\n    n = 1000\n    return n\nwait()\nfrom microbit import *\nsleep(500)\n'),
    );
    const within = { file: 'main.py', line: 7 };
    expect((await look({ kind: 'back', at: at(300_000), within }))?.variables.stack[0]?.line).toBe(6);
    expect((await look({ kind: 'back', at: at(300_000) }))?.variables.stack[0]?.line).toBe(7);
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

  it('names the line that made the robot turn or stand, at any moment, and goes to where that line began', async () => {
    const main = `from mbrobot import *
setSpeed(40)
forward()
delay(300)
def corner():
    left()
    delay(200)
corner()
stop()
delay(2000)
`;
    const look = lookerInto(runOf(main));
    const wheel = async (timeUs: number): Promise<Cause | undefined> =>
      (await look.why({ device: 0, timeUs })).find(({ output }) => output === 'wheel-left');
    for (const timeUs of [2_000_000, 400_000, 100_000, 2_400_000])
      expect((await wheel(timeUs))?.lines[0]?.line).toBe(timeUs > 600_000 ? 9 : timeUs > 350_000 ? 6 : 3);
    expect(await wheel(100)).toBeUndefined();
    const turned = await wheel(400_000);
    expect(turned?.lines).toEqual([
      { file: 'main.py', line: 6 },
      { file: 'main.py', line: 8 },
    ]);
    const found = await look({
      kind: 'line',
      at: at(turned!.sinceUs),
      place: turned!.lines[0]!,
    });
    expect(found?.variables.stack.map(({ line }) => line)).toEqual([6, 8]);
    expect(found?.snapshot.position?.line).toBe(6);
  });

  it('goes to the moment itself where the line had been at work for long', async () => {
    const look = lookerInto(runOf('from mbrobot import *\nfrom microbit import *\ndisplay.scroll("Hello")\nstop()'));
    const [shown] = await look.why({ device: 0, timeUs: 1_000_000 });
    const found = await look({ kind: 'line', at: at(1_000_000), place: shown!.lines[0]! });
    expect([found?.timeUs, found?.snapshot.position?.line]).toEqual([1_000_000, 3]);
  });

  it('names the line of each line in the console, also of two at the same time and after empty ones', async () => {
    const main = 'print("a")\nprint()\nprint("b", 1)\nfor i in range(3):\n    print("c\\nd")\n';
    const setup = runOf(main);
    const look = lookerInto(setup);
    // Regardless of the size of the pieces in which the page has run it: the clock then shows another time when it
    // prints.
    for (const pieceUs of [20_000, 1_700, 300]) {
      let startUs: number | null = null;
      const run = await Simulation.create(setup, firmware, { print: () => (startUs ??= run.nowUs) });
      for (let us = 0; us < 60_000; us += pieceUs) run.advanceTo(us);
      const lines: unknown[] = [];
      for (let printed = 0; printed < 8; printed++)
        lines.push((await look.why({ device: 0, timeUs: startUs ?? 0, printed }))[0]?.lines[0]?.line);
      expect(lines).toEqual([1, 3, 5, 5, 5, 5, 5, 5]);
    }
    expect(await look.why({ device: 0, timeUs: 1_000_000, printed: 0 })).toEqual([]);
  });
});
