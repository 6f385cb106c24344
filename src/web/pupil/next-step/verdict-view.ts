import type { Vec } from '#core/geometry';
import type { Point, Scene, SceneObject, Wall } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

/** One goal of the task and its progress. */
export interface Goal {
  readonly id: 'checkpoints' | 'targets' | 'blocks';
  readonly done: number;
  readonly of: number;
}

/** The goals of the task, in the order in which they are to be reached. */
export function goalsOf({ checkpoints, targets, blocks }: Verdict): readonly Goal[] {
  const goals: readonly Goal[] = [
    { id: 'checkpoints', done: checkpoints.passed, of: checkpoints.of },
    { id: 'targets', done: targets.reached, of: targets.of },
    { id: 'blocks', done: blocks.delivered, of: blocks.of },
  ];
  return goals.filter(({ of }) => of > 0);
}

/** Whole seconds that are left, or `null` without a limit. The last one shows until it is over. */
export function secondsLeft(seconds: number | null, timeUs: number): number | null {
  return seconds === null ? null : Math.max(0, Math.ceil(seconds - timeUs / 1_000_000));
}

/**
 * Place of the cause of a failed verdict or of a zone reached too early, in world mm; `null` if there is none to show.
 * On a wall and on the arena's edge it is the point nearest to the robot, on any other thing its middle.
 */
export function placeToShow({ objects, size }: Pick<Scene, 'objects' | 'size'>, verdict: Verdict): Vec | null {
  const { state, reason, by, place, early } = verdict;
  const robot = place === null ? null : { x: place.xMm, y: place.yMm };
  const isLate = state === 'open' || reason === 'time';
  if (isLate) return early === null ? null : placeOf(objects, early.id, robot);
  if (state !== 'failed') return null;
  if (reason === 'robot' || reason === 'left') return robot;
  return by === null && robot !== null ? edgeNear(size, robot) : placeOf(objects, by, robot);
}

/** The point of the arena's edge that is nearest to a place. */
function edgeNear([width, height]: Point, { x, y }: Vec): Vec {
  const [atX, atY] = [Math.min(width, Math.max(0, x)), Math.min(height, Math.max(0, y))];
  const sides: readonly Vec[] = [
    { x: 0, y: atY },
    { x: width, y: atY },
    { x: atX, y: 0 },
    { x: atX, y: height },
  ];
  const farOf = (side: Vec): number => Math.abs(side.x - atX) + Math.abs(side.y - atY);
  return sides.reduce((best, side) => (farOf(side) < farOf(best) ? side : best));
}

function wallNear({ from, to }: Pick<Wall, 'from' | 'to'>, { x, y }: Vec): Vec {
  const [alongX, alongY] = [to[0] - from[0], to[1] - from[1]];
  const squared = alongX * alongX + alongY * alongY;
  const share = squared === 0 ? 0 : ((x - from[0]) * alongX + (y - from[1]) * alongY) / squared;
  const within = Math.min(1, Math.max(0, share));
  return { x: from[0] + within * alongX, y: from[1] + within * alongY };
}

function placeOf(objects: readonly SceneObject[], id: string | null, robot: Vec | null): Vec | null {
  const object = objects.find((one) => one.id === id);
  if (object === undefined) return null;
  if (object.type === 'wall' || object.type === 'barrier') {
    const middle = { x: (object.from[0] + object.to[0]) / 2, y: (object.from[1] + object.to[1]) / 2 };
    return wallNear(object, robot ?? middle);
  }
  if (object.type === 'stroke') {
    const middle = object.points[Math.floor(object.points.length / 2)];
    return middle === undefined ? null : { x: middle[0], y: middle[1] };
  }
  return { x: object.at[0], y: object.at[1] };
}
