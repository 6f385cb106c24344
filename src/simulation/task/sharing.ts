import type { TaskRule, Zone } from '#scene/scene';
import type { Entrant, Failure, RobotFailure } from './entrant';

/** The robots of a task at one moment. */
export interface Standing {
  readonly timeUs: number;
  readonly entrants: readonly Entrant[];
  /** The failures in this step of the entrants that are still open. */
  readonly failures: ReadonlyMap<Entrant, Failure>;
  /** True if all blocks that are wanted lie in their targets. */
  readonly areDelivered: boolean;
  /** True if there is something to do besides holding out. */
  readonly hasGoal: boolean;
  readonly isLate: boolean;
  /** The zones in which the robots have to stay. */
  readonly ring: readonly Zone[];
}

/** How a task ends for the course. */
export interface Decision<F = Failure> {
  readonly state: 'passed' | 'failed';
  readonly failure: F;
  /** The robot that decided it. */
  readonly by: Entrant;
}

/** Decides a moment for each robot, and for the course; `null`: the task stays open. */
type Sharing = (standing: Standing) => Decision | null;

/** How robots share a task. `one`: only the first robot counts. */
export const sharings: Readonly<Record<TaskRule | 'one', Sharing>> = {
  one: allOfThem,
  together: allOfThem,
  all: (standing) => {
    passAll(arriving(standing), standing.timeUs);
    return allOfThem(standing);
  },
  first: firstWins,
  ring: lastInside,
  catch: firstCatches,
};

/** All have to do it, each on its own way or together on one. A mistake of one fails it for all. */
function allOfThem(standing: Standing): Decision | null {
  const { timeUs, entrants, failures, areDelivered, hasGoal } = standing;
  const failed = failAll(failures, timeUs);
  if (failed !== null) return failed;
  const isDone = hasGoal && areDelivered && entrants.every(({ route }) => route.isDone);
  return isDone ? passAll(entrants, timeUs) : overtime(standing);
}

/** The first to have been everywhere wins. An entrant that fails is out. */
function firstWins(standing: Standing): Decision | null {
  const { timeUs, entrants, failures, areDelivered } = standing;
  const won = areDelivered ? passAll(arriving(standing), timeUs) : null;
  const failed = failAll(failures, timeUs);
  if (won !== null) failAll(new Map(stillOpen(entrants).map((entrant) => [entrant, BEATEN])), timeUs);
  return won ?? (stillOpen(entrants).length === 0 ? failed : overtime(standing));
}

/** An entrant that leaves the ring or fails is out; the last one inside wins. */
function lastInside(standing: Standing): Decision | null {
  const { timeUs, entrants, failures, ring } = standing;
  const leaving = ring.length === 0 ? [] : stillOpen(entrants).filter((entrant) => !entrant.isIn(ring));
  const failed = failAll(
    new Map<Entrant, Failure>([...leaving.map((entrant) => [entrant, LEFT] as const), ...failures]),
    timeUs,
  );
  const inside = stillOpen(entrants);
  if (inside.length === 0) return failed;
  return inside.length === 1 && entrants.length > 1 ? passAll(inside, timeUs) : overtime(standing);
}

/** The first robot must touch all others; a robot that is not caught in time has passed. */
function firstCatches({ timeUs, entrants, failures, isLate }: Standing): Decision | null {
  const [catcher, ...others] = entrants;
  if (catcher === undefined) return null;
  const caught = stillOpen(others).filter((other) => other.isTouching(catcher.chassis));
  const wrong = failures.get(catcher) ?? (isLate ? TIME : undefined);
  failAll(new Map<Entrant, RobotFailure>([...failures, ...caught.map((other) => [other, CAUGHT] as const)]), timeUs);
  const free = stillOpen(others);
  if (others.length > 0 && free.length === 0 && !failures.has(catcher)) return passAll([catcher], timeUs);
  if (wrong === undefined) return null;
  passAll(free, timeUs);
  return failAll(new Map([[catcher, wrong]]), timeUs);
}

/** Once the time is over, robots that had something to do have failed; those that only had to hold out have passed. */
function overtime({ timeUs, entrants, isLate, hasGoal }: Standing): Decision | null {
  if (!isLate) return null;
  const open = stillOpen(entrants);
  return hasGoal ? failAll(new Map(open.map((entrant) => [entrant, TIME])), timeUs) : passAll(open, timeUs);
}

const LEFT = { reason: 'left', by: null } as const;
const CAUGHT = { reason: 'caught', by: null } as const;
const BEATEN = { reason: 'beaten', by: null } as const;
const TIME = { reason: 'time', by: null } as const;

const stillOpen = (entrants: readonly Entrant[]): readonly Entrant[] => entrants.filter(({ isOpen }) => isOpen);

/** Those that have been everywhere just now, and have done nothing wrong. */
const arriving = ({ entrants, failures, hasGoal }: Standing): readonly Entrant[] =>
  hasGoal ? stillOpen(entrants).filter((entrant) => entrant.route.isDone && !failures.has(entrant)) : [];

/** Passes these robots. @returns the decision for the course; `null` if there are none */
function passAll(entrants: readonly Entrant[], timeUs: number): Decision | null {
  for (const entrant of entrants) if (entrant.isOpen) entrant.pass(timeUs);
  const [by] = entrants;
  return by === undefined ? null : { state: 'passed', failure: { reason: null, by: null }, by };
}

/** Fails these robots. @returns the decision for the course; `null` if there are none */
function failAll<F extends RobotFailure>(failures: ReadonlyMap<Entrant, F>, timeUs: number): Decision<F> | null {
  for (const [entrant, failure] of failures) entrant.fail(failure, timeUs);
  const [first] = failures;
  return first === undefined ? null : { state: 'failed', failure: first[1], by: first[0] };
}
