import type { Vec } from '#core/geometry';
import { boundsOf, reachesInto } from './kinds/index';
import { isZone, zoneHolds, zoneOverlaps } from './kinds/zone';
import { isIdle } from './kinds/mover-way';
import type { Outline } from './outline';
import { identicalGroups, stuckBlocks, type Stuck } from './overlaps';
import { placementProblems, robotOutlines } from './placement';
import type { Block, Mover, Point, Scene, SceneObject, Start, Zone } from './scene';

/** Problems of a course that can still be kept. */
export type RuleCode =
  | 'robot-outside'
  | 'robot-inside'
  | 'start-on-forbidden'
  | 'done-at-start'
  | 'task-without-end'
  | 'no-ring'
  | 'start-outside-ring'
  | 'object-outside'
  | 'checkpoint-number-twice'
  | 'checkpoint-gap'
  | 'target-wants-too-many-blocks'
  | 'target-too-small'
  | 'mover-still'
  | 'guard-without-zone'
  | 'block-inside'
  | 'covered';

/** Something about a course that its author hardly wanted, and where. */
export interface RuleProblem {
  readonly code: RuleCode;
  /** Figures and words of the message, for translations. */
  readonly params: Readonly<Record<string, string | number>>;
  /** One English sentence or two: what is wrong, and what can be done. */
  readonly message: string;
  /** The place to show, in world mm; it may lie outside the arena. */
  readonly at: Point;
  /** The objects it is about; empty: the robot's start or the task. */
  readonly ids: readonly string[];
}

/** Maximum number of listed problems of one kind. Chosen: nobody reads more, and each costs a line on the screen. */
export const MOST_OF_A_KIND = 20;

/**
 * Everything about a course that can be kept but will not work as meant: to be shown to its author, never a reason to
 * refuse it.
 *
 * @param footprint convex parts of the robot at scale 1, in its own frame; empty: unknown, or no robot
 */
export function findProblems(scene: Scene, footprint: readonly Outline[]): readonly RuleProblem[] {
  const things = sorted(scene);
  const rules: readonly (readonly RuleProblem[])[] = [
    robotPlace(scene, footprint),
    furtherPlaces(scene, footprint),
    startOnForbidden(scene, things, footprint),
    scene.task.robots === 'ring' ? ringProblems(scene, things) : taskProblems(scene, things),
    outside(scene),
    numbersTwice(things),
    numberGap(things),
    tooManyBlocks(things),
    tooSmallTargets(things),
    things.movers.filter(isIdle).map(stillMover),
    guardsWithoutZone(scene.objects, things),
    stuckBlocks(scene.objects).map(blockInside),
    identicalGroups(scene.objects).map(covered),
  ];
  return rules.flatMap((problems) => problems.slice(0, MOST_OF_A_KIND));
}

/** The objects of a course, sorted as the rules need them. */
interface Things {
  readonly checkpoints: readonly Zone[];
  readonly robotTargets: readonly Zone[];
  readonly blockTargets: readonly Zone[];
  readonly forbidden: readonly Zone[];
  readonly blocks: readonly Block[];
  readonly movers: readonly Mover[];
}

function sorted({ objects }: Scene): Things {
  const targets = objects.filter((object): object is Zone => object.type === 'target');
  return {
    checkpoints: objects
      .filter((object): object is Zone => object.type === 'checkpoint')
      .sort((one, other) => one.number - other.number),
    robotTargets: targets.filter(({ blocks }) => blocks === 0),
    blockTargets: targets.filter(({ blocks }) => blocks > 0),
    forbidden: objects.filter((object): object is Zone => object.type === 'forbidden'),
    blocks: objects.filter((object): object is Block => object.type === 'block'),
    movers: objects.filter((object): object is Mover => object.type === 'mover'),
  };
}

function robotPlace(scene: Scene, footprint: readonly Outline[]): readonly RuleProblem[] {
  return placementProblems(scene, footprint).map(({ code, params, message }) => ({
    code: code === 'robot-inside' ? 'robot-inside' : 'robot-outside',
    params,
    message: message.slice(message.indexOf(': ') + 2).replace(/^a/, 'A'),
    at: scene.robot.at,
    ids: 'id' in params ? [String(params.id)] : [],
  }));
}

/** Problems of the further robots' starts; each robot is taken to be as large as the first one. */
function furtherPlaces(scene: Scene, footprint: readonly Outline[]): readonly RuleProblem[] {
  const starts = scene.objects.filter((object): object is Start => object.type === 'start');
  return starts.flatMap(({ id, at, heading }) =>
    robotPlace({ ...scene, robot: { ...scene.robot, at, heading } }, footprint).map((problem) => ({
      ...problem,
      ids: [id, ...problem.ids],
    })),
  );
}

function startOnForbidden(
  { robot }: Scene,
  { forbidden }: Things,
  footprint: readonly Outline[],
): readonly RuleProblem[] {
  const parts = robotOutlines(robot, footprint);
  return forbidden
    .filter((zone) => parts.some((part) => zoneOverlaps(zone, part)))
    .map(({ id }) => ({
      code: 'start-on-forbidden',
      params: { id },
      message: `The robot starts on the forbidden zone "${id}": the task is failed at once. Move one of them.`,
      at: robot.at,
      ids: [id],
    }));
}

function taskProblems({ robot, task }: Scene, things: Things): readonly RuleProblem[] {
  const { checkpoints, robotTargets, blockTargets } = things;
  const start: Vec = { x: robot.at[0], y: robot.at[1] };
  const others = checkpoints.length + blockTargets.length;
  const common = { params: {}, at: robot.at, ids: robotTargets.map(({ id }) => id) };
  if (others === 0 && robotTargets.length > 0 && robotTargets.every((target) => zoneHolds(target, start))) {
    const message = 'The robot starts in the target: the task is done at once. Move one of them.';
    return [{ ...common, code: 'done-at-start', message }];
  }
  if (task.noTouch && others + robotTargets.length === 0 && task.seconds === null) {
    const message =
      'Nothing must be touched, but there is nothing to reach: add a target, or a time limit to hold out.';
    return [{ ...common, code: 'task-without-end', message }];
  }
  return [];
}

/**
 * Problems of a task in which the robots must stay in the ring: there is no ring, or a robot does not start in it (the
 * first one, or one at a start of the course).
 */
function ringProblems({ robot, objects }: Scene, { robotTargets: ring }: Things): readonly RuleProblem[] {
  if (ring.length === 0) {
    const message = 'The robots have to stay in the ring, but there is none: add a target to be the ring.';
    return [{ code: 'no-ring', params: {}, message, at: robot.at, ids: [] }];
  }
  const further = objects.filter((object): object is Start => object.type === 'start');
  const starts = [{ at: robot.at, ids: [] }, ...further.map(({ at, id }) => ({ at, ids: [id] }))];
  const message = 'A robot starts outside of the ring: it is out at once. Move one of them.';
  return starts
    .filter(({ at: [x, y] }) => !ring.some((zone) => zoneHolds(zone, { x, y })))
    .map((start) => ({ code: 'start-outside-ring', params: {}, message, ...start }));
}

function outside({ objects, size }: Scene): readonly RuleProblem[] {
  return objects
    .filter((object) => !reachesInto(object, size))
    .map((object) => ({
      code: 'object-outside',
      params: { id: object.id, kind: object.type },
      message: `The ${object.type} "${object.id}" lies outside the arena. Move it inwards or remove it.`,
      at: middleOf(object),
      ids: [object.id],
    }));
}

function numbersTwice({ checkpoints }: Things): readonly RuleProblem[] {
  return groupsOf(checkpoints, ({ number }) => number).map((same) => {
    const [first] = same;
    const number = first?.number ?? 0;
    return {
      code: 'checkpoint-number-twice',
      params: { number, count: same.length },
      message: `${same.length} checkpoints have the number ${number}. Give each its own.`,
      at: same[1]?.at ?? [0, 0],
      ids: same.map(({ id }) => id),
    };
  });
}

/** The things with the same key, group by group; groups of one are left out. */
function groupsOf<T>(things: readonly T[], keyOf: (thing: T) => unknown): readonly (readonly T[])[] {
  const groups = new Map<unknown, T[]>();
  for (const thing of things) {
    const key = keyOf(thing);
    const group = groups.get(key);
    if (group) group.push(thing);
    else groups.set(key, [thing]);
  }
  return [...groups.values()].filter((group) => group.length > 1);
}

function numberGap({ checkpoints }: Things): readonly RuleProblem[] {
  let missing = 1;
  for (const { id, number, at } of checkpoints) {
    if (number > missing) {
      const message = `There is a checkpoint ${number} but no checkpoint ${missing}. Number them without gaps.`;
      return [{ code: 'checkpoint-gap', params: { number, missing }, message, at, ids: [id] }];
    }
    missing = number + 1;
  }
  return [];
}

function tooManyBlocks({ blockTargets, blocks }: Things): readonly RuleProblem[] {
  const wanted = blockTargets.reduce((sum, target) => sum + target.blocks, 0);
  const there = blocks.length;
  const [first] = blockTargets;
  if (!first || wanted <= there) return [];
  const message = `The targets want ${wanted} movable blocks, but there are ${there}. Add blocks, or let the targets want fewer.`;
  const ids = blockTargets.map(({ id }) => id);
  return [{ code: 'target-wants-too-many-blocks', params: { wanted, there }, message, at: first.at, ids }];
}

/** Targets that no block fits into, however it is turned: each block's shorter side is longer than the target's. */
function tooSmallTargets({ blockTargets, blocks }: Things): readonly RuleProblem[] {
  const smallest = blocks.reduce((least, { size }) => Math.min(least, size[0], size[1]), Infinity);
  if (blocks.length === 0) return [];
  return blockTargets
    .filter(({ size }) => smallest > Math.min(size[0], size[1]))
    .map(({ id, at }) => ({
      code: 'target-too-small',
      params: { id },
      message: `The target "${id}" is too small for every movable block. Make it larger.`,
      at,
      ids: [id],
    }));
}

const stillMover = ({ id, at }: Mover): RuleProblem => ({
  code: 'mover-still',
  params: { id },
  message: `The moving block "${id}" stands still: it turns round where it starts. Give it a way to go.`,
  at,
  ids: [id],
});

function guardsWithoutZone(objects: readonly SceneObject[], { movers }: Things): readonly RuleProblem[] {
  const guards = movers.filter(({ chases }) => chases?.zone !== undefined);
  if (guards.length === 0) return [];
  const zones = new Set(objects.filter(isZone).map(({ id }) => id));
  return guards
    .filter(({ chases }) => !zones.has(chases?.zone ?? ''))
    .map(({ id, at, chases }) => ({
      code: 'guard-without-zone',
      params: { id, zone: chases?.zone ?? '' },
      message: `The moving block "${id}" guards the zone "${chases?.zone ?? ''}", which is not there: it never moves. Choose another zone, or let it chase robots everywhere.`,
      at,
      ids: [id],
    }));
}

const blockInside = ({ block, other }: Stuck): RuleProblem => ({
  code: 'block-inside',
  params: { id: block.id, other: other.id, kind: other.type },
  message: `The block "${block.id}" stands inside the ${other.type} "${other.id}". Move one of them.`,
  at: block.at,
  ids: [block.id, other.id],
});

function covered(same: readonly SceneObject[]): RuleProblem {
  const [first] = same;
  const [kind, count] = [first?.type ?? '', same.length];
  return {
    code: 'covered',
    params: { kind, count },
    message: `${count} times the same ${kind} lies at the same place, and only one is seen. Remove the others.`,
    at: first ? middleOf(first) : [0, 0],
    ids: same.map(({ id }) => id),
  };
}

/** The middle of the rectangle around an object, in whole mm. */
function middleOf(object: SceneObject): Point {
  const { minX, minY, maxX, maxY } = boundsOf(object);
  return [Math.round((minX + maxX) / 2), Math.round((minY + maxY) / 2)];
}
