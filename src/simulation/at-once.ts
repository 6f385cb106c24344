import { isSame } from '#core/same';
import { touchedBy, type Step } from '#scene/history';
import type { Scene, SceneObject } from '#scene/scene';
import { isLasting, isMovable } from './kinds';

/** True if the difference between two courses affects a run at once; labels and changes for the next start do not. */
export function changesRun(before: Scene, after: Scene): boolean {
  if (before === after) return false;
  const rules = ({ task: { seconds, noTouch, robots }, league, ambient }: Scene) => [
    ...[seconds, noTouch, robots, league ?? null, ambient ?? null],
  ];
  if (!isSame(rules(before), rules(after))) return true;
  return !isSame(before.background, after.background) || !isSame(feltIn(before), feltIn(after));
}

const feltIn = ({ objects }: Scene): readonly SceneObject[] =>
  objects.filter((object) => object.type !== 'label' && !isLasting(object));

/** True if a step changes anything solid, the robot's start or the arena: pictures of an earlier run are then wrong. */
export function movesBodies(step: Step): boolean {
  const { objects, robot, size } = touchedBy(step);
  return robot || size || objects.some((object) => isMovable(object) || isLasting(object));
}

/**
 * Ids of the movable blocks that a run has after its course was changed. A block that was added to the course is there
 * at once, unless it lies outside the run's arena, or the run has a lasting object of its id from which it was changed.
 * A block that was changed into a lasting object stays movable until the next start.
 *
 * @param before the ids so far; empty before the start
 * @param began the course that the run began with
 */
export function movableIds(before: ReadonlySet<string>, began: Scene, course: Scene): ReadonlySet<string> {
  if (course === began) return new Set(began.objects.filter(isMovable).map(({ id }) => id));
  const lastingIds = new Set(began.objects.filter(isLasting).map(({ id }) => id));
  const [width, height] = began.size;
  const ids = new Set<string>();
  for (const object of course.objects) {
    const { id } = object;
    if (before.has(id) && (isMovable(object) || isLasting(object))) ids.add(id);
    if (!isMovable(object) || lastingIds.has(id) || !('at' in object)) continue;
    const [x, y] = object.at;
    if (x >= 0 && x <= width && y >= 0 && y <= height) ids.add(id);
  }
  return ids;
}

/** The parts of a course that are not yet in a run. */
export interface Pending {
  /** Objects of the course that the run does not have. */
  readonly coming: readonly SceneObject[];
  /** Objects of the run that the course no longer has, or has in another form. */
  readonly going: readonly SceneObject[];
  /** True if the start of the robot, or the robot itself, has changed. */
  readonly robot: boolean;
  /** True if the arena or the board has changed. */
  readonly arena: boolean;
}

/**
 * The changes that wait for the next start.
 *
 * @param began the course with which the run began
 * @param course the course now
 */
export function pendingChanges(began: Scene, course: Scene): Pending {
  const lasting = new Map(began.objects.filter(isLasting).map((object) => [object.id, object]));
  const movable = movableIds(new Set(), began, course);
  const coming = course.objects.filter((object) => {
    if (isMovable(object)) return !movable.has(object.id);
    if (!isLasting(object)) return false;
    const old = lasting.get(object.id);
    if (old === undefined || !isSame(old, object)) return true;
    lasting.delete(object.id);
    return false;
  });
  return {
    coming,
    going: [...lasting.values()],
    robot: !isSame(began.robot, course.robot),
    arena: !isSame(began.size, course.size) || began.board !== course.board,
  };
}
