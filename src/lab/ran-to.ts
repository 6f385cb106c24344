import { TrailKeeper } from '#check/run/trail';
import type { RunOutlets } from '#simulation/outlets';
import { msOf, robotReport } from '#simulation/report';
import type { RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Verdict } from '#simulation/task/verdict';
import type { Outcome, OutcomeReason, RunResult } from './outcome';
import { runningTo, type RunEnd } from './run-end';

/** Means for runs. */
export interface Runner {
  readonly firmware: WebAssembly.Module;
  /** Called after each slice: a sign of life. */
  readonly beat: () => void;
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
