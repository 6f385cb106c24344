import { applyEdit, singleEdits, type SceneEdit } from '#scene/edit';
import { boundsOf, solidParts } from '#scene/kinds/index';
import { isZone } from '#scene/kinds/zone';
import type { Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { RuleProblem } from '#scene/rules';
import {
  sceneLimits,
  type Block,
  type Mover,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Start,
  type Zone,
} from '#scene/scene';
import { cornersOf } from '../bounds';
import { changing, combined, removing, startingAt } from '../edits';
import { solidsBut, wayInside, wayToRoom } from './free-place';
import { movedBy } from '../kinds/index';
import { withWay } from '../kinds/mover-does';

/** The effect of the quick fix for a problem of a course. */
export type MendKind =
  | 'robot-aside'
  | 'block-aside'
  | 'bring-in'
  | 'renumber'
  | 'fewer-blocks'
  | 'larger-target'
  | 'remove-copies'
  | 'limit-time'
  | 'guard-nearest';

/** A way out of a problem, as one edit. */
export interface Mend {
  readonly kind: MendKind;
  readonly edit: SceneEdit;
}

/** The time limit given to a task that would never end, in s. Chosen: long enough for a first try. */
const TIME_LIMIT_S = 60;
/** A target that was too small becomes this much longer than the block, in mm: it can be pushed in at a slant. */
const ROOM_IN_TARGET_MM = 20;

/**
 * The quick fix of a problem; `null`: any would be a guess, or would change something locked.
 *
 * @param footprint convex parts of the robot at scale 1, in its own frame; empty: no robot
 */
export function mendOf(scene: Scene, problem: RuleProblem, footprint: readonly Outline[]): Mend | null {
  const mend = wayOut(scene, problem, footprint);
  return mend && isAllowed(scene, mend.edit) ? mend : null;
}

/** True if an edit changes nothing that is locked. */
function isAllowed({ objects }: Scene, edit: SceneEdit): boolean {
  const locked = new Set(objects.flatMap(({ id, lock }) => (lock ? [id] : [])));
  const changed = singleEdits(edit).flatMap((one) => {
    if (one.type === 'remove') return one.ids;
    return one.type === 'replace' ? one.changes.map(({ id }) => id) : [];
  });
  return !changed.some((id) => locked.has(id));
}

function wayOut(scene: Scene, problem: RuleProblem, footprint: readonly Outline[]): Mend | null {
  const objects = scene.objects.filter(({ id }) => problem.ids.includes(id));
  const mend = (kind: MendKind, edit: SceneEdit | null): Mend | null => edit && { kind, edit };
  switch (problem.code) {
    case 'robot-outside':
    case 'start-on-forbidden':
      return mend('robot-aside', robotAside(scene, objects, footprint));
    case 'robot-inside':
      return robotFreed(scene, objects, footprint);
    case 'object-outside':
      return mend('bring-in', changing(objects.flatMap((object) => broughtIn(scene, object, footprint) ?? [])));
    case 'block-inside':
      return mend('block-aside', blockAside(scene, objects, footprint));
    case 'checkpoint-number-twice':
    case 'checkpoint-gap':
      return mend('renumber', renumbered(scene));
    case 'target-wants-too-many-blocks':
      return mend('fewer-blocks', fewerBlocks(scene));
    case 'target-too-small':
      return mend('larger-target', largerTarget(scene, objects));
    case 'covered':
      return mend('remove-copies', removing(objects.slice(0, -1).map(({ id }) => id)));
    case 'task-without-end':
      return mend('limit-time', { type: 'course', changes: { task: { ...scene.task, seconds: TIME_LIMIT_S } } });
    case 'guard-without-zone':
      return mend('guard-nearest', guardingNearest(scene, objects));
    case 'done-at-start':
    case 'no-ring':
    case 'start-outside-ring':
    case 'mover-still':
      return null;
    default:
      return problem.code satisfies never;
  }
}

/**
 * Mends all of these problems that can be mended, one after the other, as one edit; `null` if none can.
 */
export function mendAll(
  scene: Scene,
  problems: readonly RuleProblem[],
  footprint: readonly Outline[],
): SceneEdit | null {
  const edits: SceneEdit[] = [];
  let now = scene;
  for (const problem of problems) {
    const mend = mendOf(now, problem, footprint);
    if (mend === null) continue;
    now = applyEdit(now, mend.edit);
    edits.push(mend.edit);
  }
  return combined(edits);
}

/** The outlines that the robot must not stand on or in: solid things, and zones that it may not enter. */
const closedToRobot = (scene: Scene): readonly Outline[] => [
  ...solidsBut(scene, []),
  ...scene.objects.filter(({ type }) => type === 'forbidden').map((zone) => cornersOf(boundsOf(zone))),
];

/** Everything solid beside a thing, the robot at its start among it. */
const around = (scene: Scene, { id }: SceneObject, footprint: readonly Outline[]): readonly Outline[] => [
  ...solidsBut(scene, [id]),
  ...robotOutlines(scene.robot, footprint),
];

/** The start of the first robot, or of the further one that a problem is about, at the nearest free place. */
function robotAside(scene: Scene, about: readonly SceneObject[], footprint: readonly Outline[]): SceneEdit | null {
  const further = about.find((object): object is Start => object.type === 'start');
  const { at, heading } = further ?? scene.robot;
  const start: RobotStart = { ...scene.robot, at, heading };
  const way = wayToRoom(robotOutlines(start, footprint), closedToRobot(scene), scene.size);
  if (way === null) return null;
  return further === undefined
    ? startingAt(scene, { at: [at[0] + way[0], at[1] + way[1]] })
    : changing([movedBy(further, way[0], way[1])]);
}

/** The guards among these guard the nearest zone; `null`: there is none. */
function guardingNearest(scene: Scene, about: readonly SceneObject[]): SceneEdit | null {
  const guards = about.filter((object): object is Mover => object.type === 'mover');
  return scene.objects.some(isZone) ? changing(guards.map((guard) => withWay(guard, 'guards', scene))) : null;
}

/** A movable block makes room for the robot; from anything else the robot moves away. */
function robotFreed(scene: Scene, about: readonly SceneObject[], footprint: readonly Outline[]): Mend | null {
  const aside = about.some(({ type }) => type === 'block') ? blockAside(scene, about, footprint) : null;
  if (aside !== null) return { kind: 'block-aside', edit: aside };
  const edit = robotAside(scene, about, footprint);
  return edit && { kind: 'robot-aside', edit };
}

/** The first movable block among these that is not locked at the nearest free place, clear of the robot. */
function blockAside(scene: Scene, about: readonly SceneObject[], footprint: readonly Outline[]): SceneEdit | null {
  const block = about.find((object): object is Block => object.type === 'block' && !object.lock);
  if (!block) return null;
  const way = wayToRoom(solidParts(block), around(scene, block, footprint), scene.size);
  return way && changing([movedBy(block, way[0], way[1])]);
}

/** A thing moved wholly into the arena, a solid one to where it stands in nothing; one that is larger stays outside. */
function broughtIn(scene: Scene, object: SceneObject, footprint: readonly Outline[]): SceneObject | null {
  const inside = wayInside(boundsOf(object), scene.size);
  if (inside === null) return null;
  const home = movedBy(object, inside[0], inside[1]);
  const parts = solidParts(home);
  const aside = parts.length === 0 ? null : wayToRoom(parts, around(scene, object, footprint), scene.size);
  return aside ? movedBy(home, aside[0], aside[1]) : home;
}

/** All checkpoints numbered from 1 without gaps, in the order that they have now. */
function renumbered({ objects }: Scene): SceneEdit | null {
  const checkpoints = objects.filter((object): object is Zone => object.type === 'checkpoint');
  const inOrder = [...checkpoints].sort((one, other) => one.number - other.number);
  const changed = inOrder.map((zone, index) => (zone.number === index + 1 ? zone : { ...zone, number: index + 1 }));
  return changing(changed.filter((zone) => !checkpoints.includes(zone)));
}

/** The targets want no more blocks than there are, each at least one; the one that wants most gives first. */
function fewerBlocks({ objects }: Scene): SceneEdit | null {
  const there = objects.filter(({ type }) => type === 'block').length;
  const targets = objects.filter((object): object is Zone => object.type === 'target' && object.blocks > 0);
  if (targets.length > there) return null;
  const wants = targets.map(({ blocks }) => blocks);
  for (let sum = wants.reduce((all, one) => all + one, 0); sum > there; sum -= 1) {
    const most = wants.indexOf(Math.max(...wants));
    wants[most] = (wants[most] ?? 1) - 1;
  }
  return changing(
    targets.flatMap((target, index) => {
      const blocks = wants[index] ?? target.blocks;
      return blocks === target.blocks ? [] : [{ ...target, blocks }];
    }),
  );
}

/** Enlarges the target to hold the smallest movable block; `null` if it would become too large. */
function largerTarget({ objects }: Scene, about: readonly SceneObject[]): SceneEdit | null {
  const blocks = objects.filter((object): object is Block => object.type === 'block');
  const needed = Math.min(...blocks.map(({ size }) => Math.max(...size))) + ROOM_IN_TARGET_MM;
  const { max } = sceneLimits.blockMm;
  const target = about.find((object): object is Zone => object.type === 'target');
  if (target === undefined || blocks.length === 0 || needed > max) return null;
  const size = [Math.max(needed, target.size[0]), Math.max(needed, target.size[1])] as const;
  return changing([{ ...target, size }]);
}
