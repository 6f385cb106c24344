import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { defaultScene } from '#scene/scene';
import type { InputAction } from '#simulation/input';
import { soloRun, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { convoyOf } from '#simulation/testing/convoy';
import type { BreakPoint } from '#vm/debug/stops';
import { Looker } from './look/looker';
import type { Instant, Look } from './look/protocol';
import type { FromWorker, ToWorker } from './protocol';
import { Runner } from './runner';
import { randomProgram } from './testing/programs';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

/** Until then each run is compared. */
const UNTIL_US = 800_000;
/** It is disturbed until then; actions begun before may take some time. */
const DISTURBED_US = 600_000;
/** Maximum number of disturbances, and of continuations from an earlier moment. */
const MOST_DEEDS = 60;
const MOST_GOING_ON = 2;

/** A run and its undisturbed repetition take a tenth of a second and more: few by default, three times as many in `npm run fuzz`. */
const IS_LONG = fuzzRuns > 1_000;
const PROGRAMS = IS_LONG ? 66 : 22;
/** One of so many pure programs. */
const EACH_PURE = IS_LONG ? 8 : 24;
const CONVOYS = IS_LONG ? 2 : 1;

/** Result of a run. */
interface Outcome {
  readonly hash: string;
  readonly output: readonly string[];
  readonly free: readonly number[];
  readonly timeUs: number;
  readonly ended: readonly unknown[];
}

const outcomeOf = (run: Simulation, output: readonly string[]): Outcome => ({
  hash: run.traceHash,
  output,
  free: output.map((_, device) => run.heapFree(device)),
  timeUs: run.nowUs,
  ended: run.endings,
});

async function undisturbed(setup: RunSetup): Promise<Outcome> {
  const output = setup.devices.map(() => '');
  const run = await Simulation.create(setup, firmware, {
    print: (text, device) => void (output[device] = (output[device] ?? '') + text),
  });
  run.advanceTo(UNTIL_US);
  return outcomeOf(run, output);
}

/** A worker whose wall clock is set by the test, and its messages. */
class Worker {
  run: Simulation | null = null;
  readonly output: string[];
  held: Extract<FromWorker, { type: 'held' }> | null = null;
  told: Extract<FromWorker, { type: 'variables' }> | null = null;
  private wallMs = 0;
  private readonly tasks: { readonly task: () => void; readonly atMs: number }[] = [];
  private readonly runner: Runner;

  constructor(readonly setup: RunSetup) {
    this.output = setup.devices.map(() => '');
    this.runner = new Runner({
      post: (message) => this.hear(message),
      nowMs: () => this.wallMs,
      later: (task, delayMs) => void this.tasks.push({ task, atMs: this.wallMs + delayMs }),
      create: async (kept, vm, { print, ...outlets }) => {
        const add = (text: string, device: number): void => {
          this.output[device] = (this.output[device] ?? '') + text;
          print?.(text, device);
        };
        return (this.run = await Simulation.create(kept, vm, { ...outlets, print: add }));
      },
    });
    this.say({ type: 'prepare', firmware });
  }

  async begin(paused: boolean, catchUpUs = 0): Promise<void> {
    this.say({ type: 'run', setup: this.setup, speed: 1, paused, catchUpUs });
    while (this.run === null) await Promise.resolve();
    for (let times = 0; times < 5; times++) await Promise.resolve();
    while (this.run.nowUs < catchUpUs) {
      this.pass(1);
      await Promise.resolve(); // the page takes the output
    }
  }

  say(message: ToWorker): void {
    this.runner.receive(message);
  }

  /** Lets wall time pass. */
  pass(ms: number): void {
    this.wallMs += ms;
    for (const { task } of this.tasks.splice(0)) task();
  }

  get nowUs(): number {
    return this.run?.nowUs ?? 0;
  }

  private hear(message: FromWorker): void {
    if (message.type === 'console') queueMicrotask(() => this.say({ type: 'console-taken' }));
    if (message.type === 'failed' || message.type === 'refused') throw new Error(message.message);
    if (message.type === 'held') this.held = message;
    if (message.type === 'variables') this.told = message;
  }
}

/** Inspects a moment of the run, as the page does for looking back. */
function lookedAt(setup: RunSetup, at: Instant): Promise<Look> {
  return new Promise((resolve, reject) => {
    const looker = new Looker({
      post: (message) => {
        if (message.type === 'looked' && message.look !== null) resolve(message.look);
        else if (message.type !== 'looked' || message.look === null) reject(new Error(JSON.stringify(message)));
      },
      nowMs: () => 0,
      rest: () => Promise.resolve(),
    });
    looker.receive({ type: 'look-into', firmware, setup });
    looker.receive({ type: 'look', ask: 1, wish: { kind: 'moment', at } });
  });
}

/** While a run is held, looking back must find its current variables. @returns whether it is held */
async function isSeenAgain(worker: Worker): Promise<boolean> {
  const { run, held, setup } = worker;
  if (run === null || held === null || held.timeUs !== run.timeOf(held.device)) return false;
  worker.say({ type: 'inspect', device: held.device });
  const at = { device: held.device, timeUs: held.timeUs, isLine: true };
  const look = await lookedAt({ ...setup, inputs: run.inputLog }, at);
  expect(look.variables).toEqual(worker.told?.variables);
  return true;
}

const PRESSES: readonly InputAction[] = [
  { type: 'button', button: 'a', down: true },
  { type: 'button', button: 'a', down: false },
  { type: 'sensor', id: 'lightLevel', value: 70 },
  { type: 'radio', text: 'hello' },
];

/** Number of disturbances of all runs, by kind. */
const done = new Map<string, number>();

/**
 * Runs a program while applying the actions of a debugger and a time line, at random. @returns its outcome, and that of
 * its undisturbed repetition
 */
async function disturbed(setup: RunSetup, rng: Rng): Promise<readonly [Outcome, Outcome]> {
  const below = (most: number): number => rng.u32() % most;
  const anyDevice = (): number => below(setup.devices.length);
  const pointsOf = (device: number): BreakPoint[] => {
    const files = Object.entries(setup.devices[device]?.files ?? {});
    return Array.from({ length: 1 + below(4) }, () => {
      const [file = '', text = ''] = files[below(files.length)] ?? [];
      return { file, line: 1 + below(text.split('\n').length) };
    });
  };
  const count = (deed: string): void => void done.set(deed, (done.get(deed) ?? 0) + 1);
  let points: (readonly BreakPoint[])[] = [];
  let worker = new Worker(setup);
  let goings = 0;
  await worker.begin(rng.unit() < 0.5);
  for (let deeds = 0; deeds < MOST_DEEDS && worker.nowUs < DISTURBED_US; deeds++) {
    const deed = below(12);
    if (deed < 3) {
      count('step-line');
      worker.held = null;
      worker.say({ type: 'pause' });
      const place = pointsOf(0)[0] ?? { file: 'main.py', line: 1 };
      const step = (['over', 'into', 'out', place] as const)[below(4)] ?? 'over';
      worker.say({ type: 'step-line', step, device: anyDevice() });
    } else if (deed === 3) {
      count('break-points');
      points = setup.devices.map((_, device) => (rng.unit() < 0.6 ? pointsOf(device) : []));
      worker.say({ type: 'break-points', points });
    } else if (deed === 4) {
      count('no break-points');
      points = [];
      worker.say({ type: 'break-points', points });
    } else if (deed === 5) {
      count('step');
      worker.say({ type: 'step' });
    } else if (deed === 6) {
      count('press');
      worker.say({ type: 'input', action: PRESSES[below(PRESSES.length)] ?? { type: 'interrupt' } });
    } else if (deed === 7) {
      count('frame');
      worker.say({ type: 'frame' });
      worker.say({ type: 'tape' });
    } else if (deed === 8 && goings < MOST_GOING_ON && worker.run !== null && worker.nowUs > 0) {
      count('go on');
      goings += 1;
      const fromUs = 1 + below(worker.nowUs);
      const inputs = worker.run.inputLog.filter(({ timeUs }) => timeUs <= fromUs);
      worker = new Worker({ ...setup, inputs });
      worker.say({ type: 'break-points', points });
      await worker.begin(rng.unit() < 0.5, fromUs);
    } else worker.say({ type: rng.unit() < 0.7 ? 'resume' : 'pause' });
    for (let times = below(6); times > 0; times--) worker.pass(below(12));
    if (rng.unit() < 0.5) {
      count('inspect');
      worker.say({ type: 'inspect', device: anyDevice() });
    }
    await Promise.resolve();
    if (rng.unit() < 0.1 && (await isSeenAgain(worker))) count('look');
  }
  const { run } = worker;
  if (run === null) throw new Error('There is no run.');
  worker.say({ type: 'break-points', points: setup.devices.map(() => []) });
  worker.say({ type: 'pause' });
  run.advanceTo(UNTIL_US);
  return [outcomeOf(run, worker.output), await undisturbed({ ...setup, inputs: run.inputLog })];
}

const runOf = (files: Readonly<Record<string, string>>, robot: string): RunSetup =>
  soloRun({ scene: defaultScene(), files, robot, board: 'microbit-v2', seed: 3, reality: 0.5 });

async function expectUndisturbed(setup: RunSetup, seed: number): Promise<Outcome> {
  const [found, wanted] = await disturbed(setup, createRng(seed));
  expect(found, `seed ${seed}: ${JSON.stringify(setup.devices.map(({ files }) => files))}`).toEqual(wanted);
  return found;
}

describe('a run that is stepped, stopped, looked at and gone back in at random', { timeout: 120_000 }, () => {
  it(`comes to the same as the run that nobody has touched: ${PROGRAMS} programs of all kinds`, async () => {
    let printed = 0;
    for (let seed = 1; seed <= PROGRAMS; seed++) {
      const rng = createRng(seed);
      const robot = seed % 3 === 0 ? 'maqueen-lite' : 'none';
      const { output } = await expectUndisturbed(runOf(randomProgram(rng, robot !== 'none'), robot), seed);
      if (/\n\d{4,5}\r?\n(Traceback|$)/.test(output[0] ?? '')) printed += 1; // the free memory, as its last word
    }
    expect(printed).toBeGreaterThan(PROGRAMS * 0.3);
  });

  it(`is the same with each ${EACH_PURE}th pure program, too`, async () => {
    const programs = readFileSync('src/vm/debug/testing/cpython-traces.jsonl', 'utf8').trimEnd().split('\n');
    for (const [index, line] of programs.entries()) {
      if (index % EACH_PURE !== 0) continue;
      const { program } = JSON.parse(line) as { program: string };
      await expectUndisturbed(
        runOf({ 'main.py': `${program}\nimport gc\nprint(gc.mem_free())\n` }, 'none'),
        1000 + index,
      );
    }
  });

  it.each([2, 3, 4])('is the same with %i devices that talk by radio, too', async (count) => {
    for (let seed = 1; seed <= CONVOYS; seed++) await expectUndisturbed(convoyOf(count), 2000 + 10 * count + seed);
  });

  it('has done each of these often', () => {
    const least = { 'step-line': 66, 'break-points': 20, step: 20, press: 20, frame: 20, 'go on': 6, inspect: 66, look: 8 }; // prettier-ignore
    for (const [deed, times] of Object.entries(least))
      expect(done.get(deed) ?? 0, deed).toBeGreaterThan(times * (IS_LONG ? 3 : 1));
  });
});
