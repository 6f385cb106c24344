import { TrailKeeper } from '#check/run/trail';
import type { Vec } from '#core/geometry';
import type { Point } from '#scene/scene';
import type { RunOutlets } from '#simulation/outlets';
import { msOf, robotReport } from '#simulation/report';
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Verdict } from '#simulation/task/verdict';
import { runningTo, type RunEnd } from './run-end';

/** Why a run has not passed, as a word: the judge's, or its own. */
export type OutcomeReason =
  | NonNullable<Verdict['reason']>
  /** `open`: not done when the run was over. */
  | 'open'
  | 'helped'
  /** The program ended with an error. */
  | 'exception'
  | 'panic'
  /** Inside one call that never ends. */
  | 'stuck';

/** The result of one run, as plain data. */
export interface Outcome {
  /** `null`: the course has no task. */
  readonly passed: boolean | null;
  /** Simulated time of the task's decision; without a task that of the program's end. `null`: neither came. */
  readonly atMs: number | null;
  readonly touches: number;
  readonly reason: OutcomeReason | null;
  /** The first robot at the end of the run; `null`: there is none. */
  readonly xMm: number | null;
  readonly yMm: number | null;
  readonly headingDeg: number | null;
  readonly pathMm: number | null;
  /** The run's fingerprint. */
  readonly traceHash: string;
}

/** Means for runs. */
export interface Runner {
  readonly firmware: WebAssembly.Module;
  /** Called after each slice: a sign of life. */
  readonly beat: () => void;
}

/** The result of a run. */
export interface RunResult {
  readonly outcome: Outcome;
  readonly verdict: Verdict | null;
  /** Its way, if that was asked for. */
  readonly drive?: Drive;
}

/** The way of the first robot, thinned, and the simulated time at the end of the run. */
export interface Drive {
  readonly way: readonly (readonly Point[])[];
  readonly endUs: number;
  /** Places of its line sensors, robot frame, on the real robot; in mm. */
  readonly lineMm: readonly Vec[];
}

/** Takes a run to its end. @param withDrive its way is kept */
export async function ranTo(
  setup: RunSetup,
  end: RunEnd,
  { firmware, beat }: Runner,
  withDrive = false,
): Promise<RunResult> {
  const trail = withDrive ? new TrailKeeper() : null;
  // The programs' output is not kept: of a hundred thousand runs nobody reads it.
  const simulation = await Simulation.create(setup, firmware, { print: () => undefined, ...trailOutlet(trail) });
  beat();
  const { isOver, advance } = runningTo(simulation, end);
  while (!isOver()) {
    advance();
    beat();
  }
  const { verdict } = simulation;
  const outcome = outcomeOf(simulation, verdict);
  const drive = trail && {
    ...{ way: trail.way().trail, endUs: simulation.nowUs },
    lineMm: (simulation.snapshot().robot?.state.lineSensors ?? []).map(({ atMm }) => atMm),
  };
  simulation.dispose();
  return { outcome, verdict, ...(drive && { drive }) };
}

/** The part of a run that tells its first robot's way; nothing where nobody wants it. */
const trailOutlet = (keeper: TrailKeeper | null): Pick<RunOutlets, 'trail'> =>
  keeper === null
    ? {}
    : {
        trail: (point, device) => {
          if (device === 0) keeper.add(point, 0);
        },
      };

function outcomeOf(simulation: Simulation, verdict: Verdict | null): Outcome {
  const { robot } = simulation.snapshot();
  const report = robot && robotReport(robot);
  const failure = failureOf(simulation);
  return {
    passed: verdict && verdict.state === 'passed',
    atMs: verdict === null ? endedMs(simulation) : verdict.atMs,
    touches: verdict?.touches ?? simulation.touches,
    reason: verdict === null ? failure : reasonOf(verdict, failure),
    xMm: report?.xMm ?? null,
    yMm: report?.yMm ?? null,
    headingDeg: report?.headingDeg ?? null,
    pathMm: report?.pathMm ?? null,
    traceHash: simulation.traceHash,
  };
}

/** The simulated time at which the last program ended; `null`: one still runs. */
function endedMs({ endings }: Simulation): number | null {
  const times = endings.map((ending) => ending?.timeUs ?? Infinity);
  const last = Math.max(...times);
  return last === Infinity ? null : msOf(last);
}

/** The result of a run that was stuck inside one call: nothing of it is known. */
export const stuckOutcome = (hasTask: boolean): Outcome => ({
  passed: hasTask ? false : null,
  ...{ atMs: null, touches: 0, reason: 'stuck' },
  ...{ xMm: null, yMm: null, headingDeg: null, pathMm: null, traceHash: '' },
});

/** An error that has ended one of the programs; `null`: none. */
function failureOf({ endings }: Simulation): OutcomeReason | null {
  const kinds = endings.map((ending) => ending?.kind);
  return kinds.includes('exception')
    ? 'exception'
    : kinds.includes('fault') || kinds.includes('panic')
      ? 'panic'
      : null;
}

function reasonOf({ state, reason }: Verdict, failure: OutcomeReason | null): OutcomeReason | null {
  if (state === 'passed') return null;
  return reason ?? (state === 'helped' ? 'helped' : (failure ?? 'open'));
}
