import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { Simulation } from './simulation';
import type { RobotSnapshot, Snapshot } from './snapshot';
import { courseRun } from './testing/course-run';

/** The recorded runs: courses/golden.json, made by `npm run courses:record`. */
interface Golden {
  readonly folder: string;
  readonly forMs: number;
  readonly seed: number;
  readonly traceHash: string;
  /** Simulated ms until its task is passed; `null` for courses without a task. */
  readonly passedMs: number | null;
  /** The robot's place at the end, to a thousandth of a mm. */
  readonly endMm: { readonly x: number; readonly y: number };
}

const read = (path: string): string => readFileSync(`courses/${path}`, 'utf8');
const { runs } = JSON.parse(read('golden.json')) as { readonly runs: readonly Golden[] };

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const replays = new Map<Golden, Promise<Simulation>>();

/** A run as recorded; each is driven once for all tests that use it. */
function replay(golden: Golden): Promise<Simulation> {
  const driven = replays.get(golden) ?? drive(golden);
  replays.set(golden, driven);
  return driven;
}

async function drive(
  { folder, forMs, seed }: Pick<Golden, 'folder' | 'forMs' | 'seed'>,
  which: 'solution' | 'start' = 'solution',
): Promise<Simulation> {
  const setup = { ...courseRun(folder, seed, which), keepTrace: true };
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(forMs * 1000);
  return simulation;
}

describe('a recorded run', () => {
  it.each(runs)('is the same to the last bit in $folder, and without an error', { timeout: 60_000 }, async (golden) => {
    const simulation = await replay(golden);
    expect(simulation.ended?.exception ?? null).toBeNull();
    const { xMm, yMm } = simulation.snapshot().robot!.pose;
    const endMm = { x: rounded(xMm), y: rounded(yMm) }; // how far apart two runs are, where their hashes differ
    expect({ endMm, traceHash: simulation.traceHash }).toEqual({ endMm: golden.endMm, traceHash: golden.traceHash });
  });
});

const rounded = (mm: number): number => Math.round(mm * 1000) / 1000 + 0;

/** Courses without a task. */
const WITHOUT_TASK = ['empty'];

describe.each(readdirSync('courses').filter((folder) => existsSync(`courses/${folder}/course.json`)))(
  'the course %s',
  { timeout: 60_000 },
  (folder) => {
    const golden = runs.find((run) => run.folder === folder);
    const start = `${folder}/start.py`;

    it('is driven as a golden test', () => {
      expect(golden?.folder).toBe(folder);
    });

    it('is passed by its solution, when it was recorded to be', async () => {
      if (golden === undefined) throw new Error(`courses/golden.json has no ${folder}.`);
      const { verdict } = await replay(golden);
      expect(verdict?.state ?? null).toBe(WITHOUT_TASK.includes(folder) ? null : 'passed');
      expect(verdict?.atMs ?? null).toBe(golden.passedMs);
    });

    it.runIf(existsSync(`courses/${start}`))(
      'begins with a program that runs without an error and leaves the task to the pupil',
      async () => {
        const simulation = await drive({ folder, forMs: 20_000, seed: 1 }, 'start');
        expect(simulation.ended?.exception ?? null).toBeNull();
        const trace = simulation.takeTrace();
        expect(trace.at(-1)).not.toEqual(trace[0]); // something happens at once
        expect(simulation.verdict?.state).not.toBe('passed');
      },
    );
  },
);

const masteredRun = async (
  folder: string,
): Promise<{ simulation: Simulation; snapshot: Snapshot; robot: RobotSnapshot }> => {
  const golden = runs.find((run) => run.folder === folder);
  if (golden === undefined) throw new Error(`courses/golden.json has no ${folder}.`);
  const simulation = await replay(golden);
  const snapshot = simulation.snapshot();
  if (snapshot.robot === null) throw new Error(`${folder} is driven without a robot.`);
  return { simulation, snapshot, robot: snapshot.robot };
};

describe('the ready courses are mastered:', { timeout: 60_000 }, () => {
  it('the line for two laps and more, without a collision', async () => {
    const { robot } = await masteredRun('closed-line');
    expect(robot.turnedRad / (2 * Math.PI)).toBeGreaterThan(2);
    expect(robot.collisions).toBe(0);
  });

  it('the line with corners for a lap and more: over every corner, its wheels never off the line', async () => {
    const { simulation, robot } = await masteredRun('corners');
    expect(robot.type).toBe('maqueen-plus-v2');
    expect(robot.turnedRad).toBeGreaterThan(2 * Math.PI);
    const corners = [1000, 200, 1000, 450, 700, 450, 700, 700, 200, 700, 200, 200, 1000, 200];
    const beyond = (at: number, one = NaN, other = NaN): number =>
      Math.max(0, Math.min(one, other) - at, at - Math.max(one, other));
    const trace = simulation.takeTrace();
    for (const { timeUs, xMm, yMm } of trace) {
      const away = [0, 2, 4, 6, 8, 10].map((i) =>
        Math.hypot(beyond(xMm, corners[i], corners[i + 2]), beyond(yMm, corners[i + 1], corners[i + 3])),
      );
      expect(Math.min(...away), `after ${String(timeUs / 1000)} ms`).toBeLessThan(15);
    }
    for (const i of [0, 2, 4, 6, 8, 10]) {
      const [x = NaN, y = NaN] = corners.slice(i);
      const away = trace.map(({ xMm, yMm }) => Math.hypot(xMm - x, yMm - y));
      expect(Math.min(...away), `from the corner ${String(x)}, ${String(y)}`).toBeLessThan(15);
    }
  });

  it('the obstacles for a minute without a touch, in motion and not on the spot', async () => {
    const { simulation, robot } = await masteredRun('obstacles');
    expect(robot.collisions).toBe(0);
    expect(robot.pathMm).toBeGreaterThan(4000);
    const xs = simulation.takeTrace().map(({ xMm }) => xMm);
    expect([Math.min(...xs) < 300, Math.max(...xs) > 1200]).toEqual([true, true]); // both halves of the arena
  });

  it('the ring, all three blocks outside of it', async () => {
    const { simulation, snapshot } = await masteredRun('clear-the-ring');
    expect(simulation.ended?.kind).toBe('finished');
    for (const { xMm, yMm } of Object.values(snapshot.blocks))
      expect(Math.hypot(xMm - 500, yMm - 500)).toBeGreaterThan(380);
  });

  it('the block carried by the claw into the field, and let go', async () => {
    const { simulation, snapshot, robot } = await masteredRun('carry');
    expect(simulation.ended?.kind).toBe('finished');
    const block = snapshot.blocks['block'];
    expect(block?.xMm).toBeGreaterThan(920);
    expect(block?.xMm).toBeLessThan(1080);
    expect(block?.yMm).toBeGreaterThan(580);
    expect(block?.yMm).toBeLessThan(720);
    expect(robot.state.attachments.map(({ type, isHolding }) => ({ type, isHolding }))).toEqual([
      { type: 'claw', isHolding: false },
    ]);
  });

  it('the maze of the ultrasonic sensor to the finish, without a collision', async () => {
    const { simulation, robot } = await masteredRun('small-maze');
    expect(simulation.ended?.kind).toBe('finished');
    expect(robot.collisions).toBe(0);
    expect(robot.pose.xMm).toBeLessThan(200);
    expect(robot.pose.yMm).toBeGreaterThan(620);
  });

  it('the maze of the bumper to the finish, by touch alone', async () => {
    const { simulation, robot } = await masteredRun('bumper-maze');
    expect(robot.type).toBe('callibot');
    expect(simulation.ended?.kind).toBe('finished');
    expect(robot.collisions).toBeGreaterThan(3);
    expect(robot.pose.xMm).toBeGreaterThan(950);
    expect(robot.pose.yMm).toBeGreaterThan(480);
  });
});
