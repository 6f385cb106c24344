import { usOf } from '#core/seconds';
import type { Project } from '#project/project';
import { fitRun } from '#simulation/run-problem';
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Reason, WorldResult } from '../result';
import { isFact, usualSeconds, type ClassTask, type WorldVariant } from '../task/task';
import { reasonByEnd, type RunEnd } from './cause';
import { Judging } from './judging';
import { setupOf } from './setup';
import { STILL_US, stillness } from './stillness';
import { TrailKeeper } from './trail';
import type { RunCheck } from './watchers';

/**
 * Simulated time between two decisions on whether a run continues. Chosen: some ms of wall time, few suspensions of the
 * program.
 */
const SLICE_US = 100_000;

/** Limits of a run's duration. */
interface Course extends Pick<Runner, 'beat' | 'onlooker'> {
  readonly limitUs: number;
  readonly stillUs: number;
}

/** Looks at a run from outside. */
export interface Onlooker {
  /** Called at the beginning and after each step of the world. */
  look(run: Simulation): void;
  /** True once it does not want to see more: the run then ends undecided. */
  readonly hasEnough: boolean;
}

/** The means for a run. */
export interface Runner {
  readonly firmware: WebAssembly.Module;
  readonly beat: () => void;
  /** Left out: nobody looks. */
  readonly onlooker?: Onlooker;
}

/** Runs a hand-in in one of the task's worlds, until the checks are decided or the time is over. */
export async function runWorld(
  task: ClassTask,
  handedIn: Project,
  world: WorldVariant,
  { firmware, beat, onlooker }: Runner,
): Promise<WorldResult> {
  const setup = setupOf(task, handedIn, world);
  if ('problem' in setup) return notRun(task, world, { code: 'refused', params: { problem: setup.problem } });
  const checked = fitRun(setup);
  if ('problem' in checked) return notRun(task, world, { code: 'refused', params: { problem: checked.problem } });
  const checks = task.checks.filter((check): check is RunCheck => !isFact(check));
  const limitUs = limitOf(task, setup);
  const judging = new Judging(checks, setup.scene, limitUs);
  const trail = new TrailKeeper();
  let running: Simulation | null = null;
  const nowUs = (): number => running?.nowUs ?? 0;
  const simulation = await Simulation.create(setup, firmware, {
    ...judging.outlets(nowUs),
    step: () => {
      if (running === null) return;
      judging.step(running);
      if (!judging.isDone) onlooker?.look(running);
    },
    trail: (point, device) => {
      if (device === 0 && !judging.isDone) trail.add(point, nowUs());
    },
  });
  running = simulation;
  runToEnd(simulation, judging, { limitUs, stillUs: stillUs(checks), beat, ...(onlooker && { onlooker }) });
  const { id, hidden } = world;
  judging.end(simulation);
  const { hasMoved } = judging;
  const end: RunEnd = { ended: simulation.ended, hasMoved, files: setup.devices[0].files, world };
  const isCut = end.ended === null && simulation.nowUs >= limitUs;
  const outcome = judging.outcome(
    (check, failedUs) => reasonByEnd(end, check, failedUs),
    isCut ? { limit: limitUs / 1_000_000 } : {},
  );
  const hash = simulation.traceHash;
  simulation.dispose();
  return { id, hidden, ...outcome, hash, ...trail.way() };
}

/** The result of a world in which nothing could run. */
export function notRun({ checks }: ClassTask, { id, hidden }: WorldVariant, reason: Reason): WorldResult {
  const runs = checks.filter((check) => !isFact(check));
  const missed = Object.fromEntries(runs.map((check) => [check.id, reason]));
  return {
    id,
    hidden,
    passed: false,
    reason,
    atMs: null,
    touches: 0,
    held: [],
    missed,
    hash: '',
    trail: [],
    trailMs: [],
  };
}

/** The longest time of a run. The course's own limit decides in its last step. */
function limitOf({ seconds }: ClassTask, { scene }: RunSetup): number {
  if (seconds !== null) return usOf(seconds);
  return usOf(usualSeconds(scene)) + (scene.task.seconds === null ? 0 : SLICE_US);
}

/** Lets the run go on until it is decided, its time is over, or nothing more can happen. */
function runToEnd(simulation: Simulation, judging: Judging, { limitUs, stillUs, beat, onlooker }: Course): void {
  const isStill = stillness(simulation, stillUs);
  for (;;) {
    if (judging.isDone || onlooker?.hasEnough === true) return;
    if (simulation.nowUs >= limitUs || simulation.isOff || isStill()) return;
    simulation.advanceTo(Math.min(limitUs, simulation.nowUs - (simulation.nowUs % SLICE_US) + SLICE_US));
    beat();
  }
}

/** A run ends after being still for this time: the usual one, or the longest that a robot has to be somewhere for a check. */
const stillUs = (checks: readonly RunCheck[]): number =>
  Math.max(
    STILL_US,
    ...checks.map((check) => (check.type === 'stop' || check.type === 'stay' ? usOf(check.seconds) + SLICE_US : 0)),
  );
