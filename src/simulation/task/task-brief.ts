import type { Block, Scene, Task, Zone } from '#scene/scene';
import { isSpiked } from '../kinds';

/** The parts of a course that matter to the judge. */
export interface TaskBrief {
  readonly task: Task;
  /** In the order of their numbers; those of one number in the order of the course. */
  readonly checkpoints: readonly Zone[];
  /** Targets that the robot must reach. */
  readonly robotTargets: readonly Zone[];
  /** The targets, if the task is to stay in the ring. */
  readonly ring: readonly Zone[];
  /** Targets that want blocks. */
  readonly blockTargets: readonly Zone[];
  readonly forbidden: readonly Zone[];
  /** The movable blocks, in the order of the course; empty if no target wants blocks. */
  readonly blocks: readonly Block[];
  /** Number of blocks wanted in all targets together. */
  readonly blocksWanted: number;
  /** The line is scored by the rules of a league: its end is to be reached. */
  readonly isScored: boolean;
}

/** Extracts these parts from a course. */
export function briefOf({ task, objects, league }: Pick<Scene, 'task' | 'objects' | 'league'>): TaskBrief {
  const checkpoints: Zone[] = [];
  const targets: Zone[] = [];
  const forbidden: Zone[] = [];
  for (const object of objects) {
    if (object.type === 'checkpoint') checkpoints.push(object);
    else if (object.type === 'target') targets.push(object);
    else if (object.type === 'forbidden') forbidden.push(object);
  }
  const blockTargets = targets.filter(({ blocks }) => blocks > 0);
  const robotTargets = targets.filter(({ blocks }) => blocks === 0);
  const isRing = task.robots === 'ring';
  const movable = blockTargets.length > 0 ? objects.filter((object): object is Block => object.type === 'block') : [];
  return {
    task,
    checkpoints: checkpoints.sort((a, b) => a.number - b.number),
    robotTargets: isRing ? [] : robotTargets,
    ring: isRing ? robotTargets : [],
    blockTargets,
    forbidden,
    blocks: movable,
    blocksWanted: blockTargets.reduce((sum, { blocks }) => sum + blocks, 0),
    isScored: league !== undefined,
  };
}

/** True if there is something to do besides holding out: a place to reach, a block to deliver, a robot to beat, a line to follow to its end. */
export const hasGoal = ({ checkpoints, robotTargets, blockTargets, task, isScored }: TaskBrief): boolean =>
  isScored ||
  checkpoints.length + robotTargets.length + blockTargets.length > 0 ||
  task.robots === 'ring' ||
  task.robots === 'catch';

/** True if there is anything to judge, apart from spikes. */
export const isTask = (brief: TaskBrief): boolean =>
  hasGoal(brief) || brief.forbidden.length > 0 || brief.task.noTouch || brief.task.seconds !== null;

/** Ids of the obstacles that must never be touched: spikes, and movers with spikes. */
export const spikedIds = ({ objects }: Pick<Scene, 'objects'>): ReadonlySet<string> =>
  new Set(objects.filter(isSpiked).map(({ id }) => id));

/** Whether a course has a task, or something that must not be touched: then there is a verdict. */
export const hasTask = (course: Pick<Scene, 'task' | 'objects' | 'league'>): boolean =>
  isTask(briefOf(course)) || spikedIds(course).size > 0;
