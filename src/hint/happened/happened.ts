import type { Reason, WorldResult } from '#check/result';
import type { Scene } from '#scene/scene';
import type { Observed } from '../watch/observed';
import { brightAt, passedBy, standsSince, turnsSince, type PassedBy } from './way';

/** A fact about a run that did not pass, with its values; times are simulated seconds. */
export type Happened =
  | { readonly fact: 'error'; readonly atS: number | null; readonly line: number; readonly type: string }
  | { readonly fact: 'unmoved' | 'empty' | 'panic' | 'stuck' }
  | { readonly fact: 'waits'; readonly name: string }
  /** All line sensors saw light ground from then on; `answers`: the motors were set otherwise afterwards. */
  | { readonly fact: 'bright'; readonly atS: number; readonly answers: boolean }
  | { readonly fact: 'left-line'; readonly atS: number }
  | { readonly fact: 'touched' | 'forbidden' | 'spikes' | 'ring' | 'robot'; readonly atS: number }
  | ({ readonly fact: 'past' } & PassedBy)
  /** It ended before the place that was next; `nearCm`: that far from it at best. */
  | { readonly fact: 'ended'; readonly atS: number; readonly nearCm: number | null }
  | { readonly fact: 'stands' | 'turns'; readonly atS: number }
  | { readonly fact: 'slow' | 'early'; readonly seconds: number }
  /** No more of the goals than these were reached. */
  | { readonly fact: 'reached'; readonly done: number; readonly of: number; readonly nearCm: number | null }
  /** A reason of the check that says all. */
  | { readonly fact: 'reason'; readonly reason: Reason };

/** How a run that did not pass came to its end. */
export interface FailedRun {
  readonly reason: Reason;
  readonly result: WorldResult | null;
  readonly seen: Observed;
  readonly course: Scene;
}

/** The rules of a course that a robot breaks at a moment. */
const BROKEN: Readonly<Record<string, 'touched' | 'forbidden' | 'spikes' | 'ring' | 'robot'>> = {
  ...{ touched: 'touched', forbidden: 'forbidden', spikes: 'spikes', left: 'ring', robot: 'robot', touches: 'touched' },
};

/** The fact that explains best why a run did not pass. */
export function happenedIn(run: FailedRun): Happened {
  const { reason, result } = run;
  const { code, params } = reason;
  const atMs = result?.atMs ?? null;
  const broken = Object.hasOwn(BROKEN, code) ? BROKEN[code] : undefined;
  if (broken !== undefined) return { fact: broken, atS: tenth((atMs ?? 0) / 1000) };
  switch (code) {
    case 'exception': {
      const atS = run.seen.endedUs === null ? null : tenth(run.seen.endedUs / 1_000_000);
      return { fact: 'error', atS, line: Number(params['line'] ?? 0), type: String(params['type'] ?? '') };
    }
    case 'unmoved':
    case 'empty':
    case 'panic':
    case 'stuck':
      return { fact: code };
    case 'waits':
      return { fact: code, name: String(params['name'] ?? '') };
    case 'early':
    case 'slow':
      return unlessWay(run, { fact: code, seconds: Number(params['seconds'] ?? 0) }, code === 'slow');
    case 'time':
    case 'open':
    case 'reach':
    case 'checkpoints':
    case 'laps':
      return unlessWay(run, notReached(reason), true);
    default:
      return unlessWay(run, { fact: 'reason', reason }, ['stop', 'stay', 'belongs', 'tiles'].includes(code));
  }
}

const notReached = ({ params }: Reason): Happened => {
  const near = params['near'];
  const [done, of] = [Number(params['done'] ?? 0), Number(params['of'] ?? 0)];
  return { fact: 'reached', done, of, nearCm: typeof near === 'number' ? near : null };
};

/** Says what the robot's way says, if it says something; else the other fact. */
function unlessWay({ reason, seen, course }: FailedRun, other: Happened, isOfWay: boolean): Happened {
  if (!isOfWay || seen.moments.length === 0) return other;
  const { leftUs, endedUs } = seen;
  const bright = leftUs === null ? null : brightAt(seen.moments, leftUs);
  if (bright !== null) return { fact: 'bright', atS: tenth(bright.atUs / 1_000_000), answers: bright.answers };
  if (leftUs !== null) return { fact: 'left-line', atS: tenth(leftUs / 1_000_000) };
  const past = passedBy(seen, course);
  if (past !== null) return { fact: 'past', ...past, atS: tenth(past.atS) };
  const near = reason.params['near'];
  if (endedUs !== null)
    return { fact: 'ended', atS: tenth(endedUs / 1_000_000), nearCm: typeof near === 'number' ? near : null };
  const stands = standsSince(seen.moments);
  if (stands === 0) return { fact: 'unmoved' };
  if (stands !== null) return { fact: 'stands', atS: tenth(stands / 1_000_000) };
  const turns = turnsSince(seen.moments);
  if (turns !== null) return { fact: 'turns', atS: tenth(turns / 1_000_000) };
  return other;
}

const tenth = (seconds: number): number => Math.round(seconds * 10) / 10;
