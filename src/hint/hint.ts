import { check } from '#check/check';
import type { HandIn } from '#check/hand-in/hand-in';
import type { Reason } from '#check/result';
import type { Onlooker } from '#check/run/run-world';
import { mainReason, visibleTask } from '#check/task/visible';
import { plainWorld, type ClassTask, type WorldVariant } from '#check/task/task';
import type { Pose, Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { linesOf, type Change } from './changes/change';
import { failedIn } from './happened/failed-in';
import { happenedIn, type Happened } from './happened/happened';
import { lengthOf } from '#scene/outline';
import type { Point } from '#scene/scene';
import type { Simulation } from '#simulation/simulation';
import { findChange } from './search';
import { mainOf } from './main-of';
import { Observed, type Moment } from './watch/observed';
import { PATIENCE, scoreOf, Stall } from './watch/stall';

/** Means for a hint. */
export interface Hinter {
  readonly firmware: WebAssembly.Module;
  /** The most programs that are tried. */
  readonly budget: number;
  /** Called often, with the place of the world that runs; from the number of worlds on: with that and the number of tries. */
  readonly beat?: (place: number) => void;
}

/** A moment of a run that did not pass. */
export interface HintMoment {
  readonly timeUs: number;
  readonly pose: Pose;
  /** The places of the line sensors that this is about, robot frame, in mm. */
  readonly sensorsMm: readonly Vec[];
  /** The robot's way until then, in mm. */
  readonly wayMm: readonly Point[];
}

/** A hint to a program, as plain data. */
export interface Hint {
  readonly reason: Reason;
  /** Id of the world in which it happened; `null`: in the course as it is. */
  readonly world: string | null;
  /** Simulated ms until it was decided; `null`: it was not. */
  readonly atMs: number | null;
  readonly happened: Happened;
  /** The moment that this is about; `null`: the robot was nowhere, or it is another world than that of the course as it is. */
  readonly moment: HintMoment | null;
  /** A change with which the program passes, proved by running it; `null`: none was found. */
  readonly change: Change | null;
  /** Number of programs that were tried. */
  readonly tried: number;
  /** The program, for the lines beside the change. */
  readonly program: string;
}

/**
 * The hint to a program: what happened in its run, and a small change with which it passes in all worlds that pupils see.
 * Neither hidden worlds nor the model solution are looked at. The same program gives the same hint on every machine.
 *
 * @returns `null`: it passes
 */
export async function hintFor(given: ClassTask, handIn: HandIn, hinter: Hinter): Promise<Hint | null> {
  const { firmware, budget, beat = () => undefined } = hinter;
  const task = visibleTask(given);
  const lines = linesOf(mainOf(handIn)).length;
  const watches = task.worlds.map(() => new Watch(task, lines));
  const onlooker = (world: number): Watch => watches[world] ?? new Watch(task, lines);
  const result = await check(task, handIn, { firmware, beat, onlooker });
  if (result.passed) return null;
  const failed = failedIn(task, result);
  const { seen, stall } = onlooker(failed.place);
  const reason = mainReason(task, result) ?? { code: 'open', params: {} };
  const happened = happenedIn({ reason, result: failed.result, seen, course: task.project.scene });
  const { change, tried } = await findChange({
    ...{ task, handIn, firmware, budget, failedIn: failed.world },
    score: failed.result === null ? -Infinity : scoreOf(stall, failed.result),
    ran: failed.result?.passed === false && seen.lastRanUs.size > 0 ? new Set(seen.lastRanUs.keys()) : null,
    suspects: suspectsIn(mainOf(handIn), seen, happened),
    isBroken: happened.fact === 'error' && ['SyntaxError', 'IndentationError'].includes(happened.type),
    beat: (count) => beat(task.worlds.length + count),
  });
  const atMs = failed.result?.atMs ?? null;
  const world = isPlain(failed.world) ? null : failed.world.id;
  const moment = world === null ? momentOf(happened, atMs, seen) : null;
  return { reason, world, atMs, happened, moment, change, tried, program: mainOf(handIn) };
}

/** True if a world is the course as it is. */
const isPlain = ({ id: _, hidden: _hidden, ...world }: WorldVariant): boolean => {
  const { id: _id, hidden: _plain, ...plain } = plainWorld;
  return isSame(world, plain);
};

/** The moment of what happened: its own time, or that of the decision, or the end of the run. */
function momentOf(happened: Happened, atMs: number | null, { moments, sensorsMm }: Observed): HintMoment | null {
  const atS = 'atS' in happened ? happened.atS : null;
  const timeUs = atS !== null ? atS * 1_000_000 : atMs !== null ? atMs * 1000 : Infinity;
  const found = moments.findLast((one) => one.timeUs <= timeUs);
  if (found === undefined) return null;
  const wayMm = wayUntil(found, moments);
  return { timeUs: found.timeUs, pose: found.pose, sensorsMm: happened.fact === 'bright' ? sensorsMm : [], wayMm };
}

/** Two points of a way are this far apart, in mm. Chosen: a curve looks round. */
const WAY_STEP_MM = 5;

/** The way until a moment; what lies closer together than a step is one point. */
function wayUntil(last: Moment, moments: readonly Moment[]): readonly Point[] {
  const way: Point[] = [];
  for (const { timeUs, pose } of moments) {
    if (timeUs > last.timeUs) break;
    const [x, y] = way.at(-1) ?? [Infinity, Infinity];
    if (lengthOf(pose.xMm - x, pose.yMm - y) >= WAY_STEP_MM) way.push([tenth(pose.xMm), tenth(pose.yMm)]);
  }
  return [...way, [tenth(last.pose.xMm), tenth(last.pose.yMm)]];
}

const tenth = (mm: number): number => Math.round(mm * 10) / 10;

/** Notes what a run does, and how far it gets; once nothing new happens in it, only which other lines run. */
class Watch implements Onlooker {
  readonly hasEnough = false;
  readonly seen = new Observed();
  readonly stall: Stall;

  constructor(
    task: ClassTask,
    private readonly lines: number,
  ) {
    this.stall = new Stall(task, PATIENCE);
  }

  look(run: Simulation): void {
    this.seen.look(run);
    if (this.stall.hasEnough) return;
    this.stall.look(run);
    if (this.stall.hasEnough) this.seen.noteLess(run, this.lines);
  }
}

/** The lines of a program, those first that ran last before it failed, and an error's before all. */
function suspectsIn(text: string, { lastRanUs }: Observed, happened: Happened): readonly number[] {
  const numbers = linesOf(text).map((_, place) => place + 1);
  const at = (line: number): number => lastRanUs.get(line) ?? -1;
  const byTime = numbers.sort((one, other) => at(other) - at(one) || one - other);
  const first = happened.fact === 'error' && happened.line > 0 ? [happened.line] : [];
  return [...new Set([...first, ...byTime])];
}
