import type { Project } from '#project/project';
import type { RunOutlets } from '#simulation/outlets';
import { checkRun } from '#simulation/run-problem';
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Reason, WorldResult } from '../result';
import { isFact, USUAL_SECONDS, type ClassTask, type WorldVariant } from '../task/task';
import { setupOf } from './setup';
import { STILL_US, stillness } from './stillness';
import { TrailKeeper } from './trail';
import { watcherOf, type RunCheck } from './watchers';
import type { Glance, Watcher } from './watcher';

/** Simulated time between two looks at a run. Chosen: some ms of wall time, few suspensions of the program. */
const SLICE_US = 100_000;

/** A check and who watches for it. */
interface Watched {
  readonly check: RunCheck;
  readonly watcher: Watcher;
}

/** Runs a hand-in in one of the task's worlds, until the checks are decided or the time is over. */
export async function runWorld(
  task: ClassTask,
  handedIn: Project,
  world: WorldVariant,
  { firmware, beat }: { readonly firmware: WebAssembly.Module; readonly beat: () => void },
): Promise<WorldResult> {
  const setup = setupOf(task, handedIn, world);
  if ('problem' in setup) return notRun(task, world, { code: 'refused', params: { problem: setup.problem } });
  const checked = checkRun(setup);
  if ('problem' in checked) return notRun(task, world, { code: 'refused', params: { problem: checked.problem } });
  const checks = task.checks.filter((check): check is RunCheck => !isFact(check));
  const watched = checks.map((check): Watched => ({ check, watcher: watcherOf(check, setup.scene) }));
  const trail = new TrailKeeper();
  let running: Simulation | null = null;
  const nowUs = (): number => running?.nowUs ?? 0;
  const simulation = await Simulation.create(setup, firmware, outletsOf(watched, trail, nowUs));
  running = simulation;
  const reachedUs = runToEnd(simulation, watched, { limitUs: limitOf(task, setup), beat });
  const { id, hidden } = world;
  const outcome = outcomeOf(simulation, watched, reachedUs);
  const { touches } = glanceAt(simulation, reachedUs);
  simulation.dispose();
  return { id, hidden, ...outcome, touches, hash: simulation.traceHash, ...trail.way() };
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
  const ofCourse = scene.task.seconds === null ? null : scene.task.seconds * 1_000_000 + SLICE_US;
  return seconds === null ? (ofCourse ?? USUAL_SECONDS * 1_000_000) : seconds * 1_000_000;
}

/** Only what somebody listens to is made. What is printed is never kept. */
function outletsOf(watched: readonly Watched[], trail: TrailKeeper, nowUs: () => number): RunOutlets {
  const having = (name: 'moment' | 'print' | 'sound' | 'radio' | 'log'): readonly Watcher[] =>
    watched.flatMap(({ watcher }) => (watcher[name] === undefined ? [] : [watcher]));
  const [moments, prints, sounds] = [having('moment'), having('print'), having('sound')];
  const [radios, logs] = [having('radio'), having('log')];
  return {
    print: (text, device) => {
      if (device === 0) for (const watcher of prints) watcher.print?.(text, nowUs());
    },
    trail: (point, device) => {
      if (device === 0) trail.add(point, nowUs());
    },
    ...(moments.length > 0 && {
      moment: (snapshot) => {
        for (const watcher of moments) watcher.moment?.(snapshot);
      },
    }),
    ...(sounds.length > 0 && {
      sound: (event, device) => {
        if (device === 0) for (const watcher of sounds) watcher.sound?.(event);
      },
    }),
    ...(radios.length > 0 && {
      radio: (packet, device) => {
        if (device === 0) for (const watcher of radios) watcher.radio?.(packet);
      },
    }),
    ...(logs.length > 0 && {
      log: (event, device) => {
        if (device === 0) for (const watcher of logs) watcher.log?.(event);
      },
    }),
  };
}

/**
 * Lets the run go on until it is decided, its time is over, or nothing more can happen.
 *
 * @returns the simulated time at which all was reached that is needed, or `null`
 */
function runToEnd(
  simulation: Simulation,
  watched: readonly Watched[],
  { limitUs, beat }: { readonly limitUs: number; readonly beat: () => void },
): number | null {
  const isStill = stillness(simulation, stillUs(watched));
  for (;;) {
    const reachedUs = look(simulation, watched);
    if (isDecided(watched) || simulation.nowUs >= limitUs || simulation.isOff || isStill()) return reachedUs;
    simulation.advanceTo(Math.min(limitUs, simulation.nowUs - (simulation.nowUs % SLICE_US) + SLICE_US));
    beat();
  }
}

/** Shows the run to all watchers, to those of the time last. @returns when all was reached that is needed, or `null` */
function look(simulation: Simulation, watched: readonly Watched[]): number | null {
  const before = glanceAt(simulation, null);
  for (const { check, watcher } of watched) if (check.type !== 'faster') watcher.glance?.(before);
  const reachedUs = reachedAt(watched);
  for (const { check, watcher } of watched) if (check.type === 'faster') watcher.glance?.({ ...before, reachedUs });
  return reachedUs;
}

function glanceAt(simulation: Simulation, reachedUs: number | null): Glance {
  const { nowUs: timeUs, verdict, touches } = simulation;
  return { timeUs, verdict, touches, reachedUs };
}

/** When the last of what is needed was reached; `null`: something is not yet, or there is nothing to reach. */
function reachedAt(watched: readonly Watched[]): number | null {
  const standings = watched.filter(({ check }) => check.needed).map(({ watcher }) => watcher.standing());
  if (standings.some(({ state }) => state === 'open')) return null;
  const times = standings.flatMap(({ state, atUs }) => (state === 'met' && atUs !== null ? [atUs] : []));
  return times.length === 0 ? null : Math.max(...times);
}

/** Something needed has failed for good; or nothing is open, and something was reached. */
function isDecided(watched: readonly Watched[]): boolean {
  const standings = watched.map(({ check, watcher }) => ({ check, state: watcher.standing().state }));
  return (
    standings.some(({ check, state }) => check.needed && state === 'failed') ||
    (standings.every(({ state }) => state !== 'open') && standings.some(({ state }) => state === 'met'))
  );
}

/** As long as usual, or as a check waits for a stop. */
const stillUs = (watched: readonly Watched[]): number =>
  Math.max(STILL_US, ...watched.map(({ check }) => (check.type === 'stop' ? check.seconds * 1_000_000 + SLICE_US : 0)));

type Outcome = Pick<WorldResult, 'passed' | 'reason' | 'atMs' | 'held' | 'missed'>;

function outcomeOf(simulation: Simulation, watched: readonly Watched[], reachedUs: number | null): Outcome {
  const ends = watched.map(({ check, watcher }) => ({ check, watcher, ...watcher.standing() }));
  // Who has touched nothing because nothing was done has not kept a rule.
  const counts =
    reachedUs !== null || !ends.some(({ check, state }) => check.needed && (state === 'open' || state === 'met'));
  const isHeld = ({ state }: (typeof ends)[number]): boolean => state === 'met' || (state === 'held' && counts);
  const lacking = ends.filter((end) => end.check.needed && (end.state === 'open' || end.state === 'failed'));
  const failed = lacking.find(({ state }) => state === 'failed');
  const first = failed ?? lacking[0];
  const passed = first === undefined;
  // What ended the run is why everything that was still to come did not.
  const ended = endReason(simulation, failed?.atUs ?? null);
  const cause = ended ?? failed?.watcher.reason() ?? null;
  const reason = first === undefined ? null : (cause ?? first.watcher.reason());
  const whyMissed = ({ state, watcher }: (typeof ends)[number]): Reason => {
    if (state === 'failed') return watcher.reason();
    return (state === 'held' ? reason : cause) ?? watcher.reason();
  };
  return {
    passed,
    reason,
    atMs: passed ? (reachedUs ?? simulation.nowUs) / 1000 : first.atUs === null ? null : first.atUs / 1000,
    held: ends.filter(isHeld).map(({ check }) => check.id),
    missed: Object.fromEntries(ends.filter((end) => !isHeld(end)).map((end) => [end.check.id, whyMissed(end)])),
  };
}

/** How the program ended, if that is why something was not reached: not where something had failed before. */
function endReason({ ended }: Simulation, failedUs: number | null): Reason | null {
  if (ended === null || (failedUs !== null && failedUs < ended.timeUs)) return null;
  if (ended.exception !== null) {
    const { type, message, line } = ended.exception;
    return { code: 'exception', params: { type, message: message.slice(0, MESSAGE_CHARACTERS), line: line ?? 0 } };
  }
  return ended.kind === 'finished' ? null : { code: 'panic', params: {} };
}

/** A program may raise an exception with a text of any length. */
const MESSAGE_CHARACTERS = 300;
