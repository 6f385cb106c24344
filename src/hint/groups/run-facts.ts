import { runWorld, type Onlooker } from '#check/run/run-world';
import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult, Reason, ReasonCode } from '#check/result';
import { mainReason } from '#check/task/visible';
import { courseOfWorld } from '#check/task/world-course';
import type { ClassTask } from '#check/task/task';
import { lengthOf } from '#scene/outline';
import type { Point, Scene } from '#scene/scene';
import { failedIn } from '../happened/failed-in';
import { happenedIn, type Happened } from '../happened/happened';
import { Observed, type Moment } from '../watch/observed';
import { PATIENCE, Stall } from '../watch/stall';
import { Track, type Departure } from './bends';
import { needsRun } from './needs-run';

/** The facts of a run that has not passed, as plain data. */
export interface RunFacts {
  /** Id of the world in which it was looked at. */
  readonly world: string;
  readonly happened: Happened;
  /** The place of the robot when it happened, in mm; `null`: nothing ran. */
  readonly at: Point | null;
  /** Number of the checkpoint that was next; `null`: the target was, or nothing. */
  readonly next: number | null;
  /** The place at which it left its line; `null`: it did not, or it cannot be told. */
  readonly departure: Departure | null;
  /** True if it moved about at one place at the end, and came no further. */
  readonly stays: boolean;
  /** Number of the bend of its line at which it was, from 1; 0: at its start; `null`: elsewhere, or there is no line. */
  readonly bend: number | null;
}

/** Reasons of programs that are not run a second time: they would hold up whoever runs them. */
const UNRUN: readonly ReasonCode[] = ['stuck', 'long', 'refused', 'broken', 'unloaded'];

/**
 * The facts of the run of a checked hand-in: it is run once more in the first world in which it has not passed.
 *
 * @returns `null`: it has passed, cannot be read, or is for another task
 */
export async function factsOf(
  task: ClassTask,
  handIn: HandIn,
  result: CheckResult,
  means: { readonly firmware: WebAssembly.Module; readonly beat?: () => void },
): Promise<RunFacts | null> {
  if (!needsRun(result)) return null;
  const { world, result: found } = failedIn(task, result);
  const reason: Reason = mainReason(task, result) ?? { code: 'open', params: {} };
  const seen = new Observed();
  const isRun = !UNRUN.includes(found?.reason?.code ?? 'open');
  const inWorld = courseOfWorld(task.project.scene, world);
  const course = 'scene' in inWorld ? inWorld.scene : task.project.scene;
  const onlooker = untilNothingNew(seen, new Stall({ ...task, project: { ...task.project, scene: course } }, PATIENCE));
  if (isRun) await runWorld(task, handIn.project, world, { beat: () => undefined, ...means, onlooker });
  const happened = happenedIn({ reason, result: found, seen, course });
  const [next] = seen.next;
  return {
    ...{ world: world.id, happened, at: placeOf(happened, seen.moments) },
    next: next?.type === 'checkpoint' ? next.number : null,
    ...lineFacts(seen.moments, course),
  };
}

/** Simulated time of the end of a run, and the radius of the place at which a robot stays meanwhile. Chosen. */
const [STAY_US, STAY_MM] = [6_000_000, 100];

function lineFacts(moments: readonly Moment[], course: Scene): Pick<RunFacts, 'departure' | 'stays' | 'bend'> {
  const [start] = moments;
  const last = moments.at(-1);
  if (start === undefined || last === undefined) return { departure: null, stays: false, bend: null };
  const isNear = (one: Moment, other: Moment): boolean =>
    lengthOf(one.pose.xMm - other.pose.xMm, one.pose.yMm - other.pose.yMm) <= STAY_MM;
  const since = last.timeUs - STAY_US;
  const stays = since >= 0 && moments.every((one) => one.timeUs < since || isNear(one, last));
  const track = Track.from(course, start);
  const bend = isNear(start, last) ? 0 : (track?.bendAt({ x: last.pose.xMm, y: last.pose.yMm }) ?? null);
  return { departure: track?.departure(moments) ?? null, stays, bend };
}

/** Sees a run until nothing new happens in it. */
const untilNothingNew = (seen: Observed, stall: Stall): Onlooker => ({
  look(run) {
    seen.look(run);
    stall.look(run);
  },
  get hasEnough() {
    return stall.hasEnough;
  },
});

/** The place of the robot when it happened; where nothing says when, at the end. */
function placeOf(happened: Happened, moments: readonly Moment[]): Point | null {
  const atUs = 'atS' in happened && happened.atS !== null ? happened.atS * 1_000_000 : Infinity;
  const moment = moments.findLast(({ timeUs }) => timeUs <= atUs) ?? moments[0];
  return moment === undefined ? null : [Math.round(moment.pose.xMm), Math.round(moment.pose.yMm)];
}
