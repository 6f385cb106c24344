import type { Vec } from '#core/geometry';
import type { Scene, SceneObject } from '#scene/scene';
import { isSpiked } from '#simulation/kinds';
import { briefOf } from '#simulation/task-brief';
import type { Verdict } from '#simulation/verdict';

/** One thing that is asked for, and how far it has come. */
export interface Goal {
  readonly id: 'checkpoints' | 'targets' | 'blocks';
  readonly done: number;
  readonly of: number;
}

/** How things stand before the start. */
export function verdictAtStart(scene: Pick<Scene, 'task' | 'objects'>): Verdict {
  const { checkpoints, robotTargets, blocksWanted } = briefOf(scene);
  return {
    state: 'open',
    atMs: null,
    reason: null,
    by: null,
    checkpoints: { passed: 0, of: checkpoints.length },
    targets: { reached: 0, of: robotTargets.length },
    blocks: { delivered: 0, of: blocksWanted },
    touches: 0,
  };
}

/** What is asked for, in the order in which it is done. */
export function goalsOf({ checkpoints, targets, blocks }: Verdict): readonly Goal[] {
  const goals: readonly Goal[] = [
    { id: 'checkpoints', done: checkpoints.passed, of: checkpoints.of },
    { id: 'targets', done: targets.reached, of: targets.of },
    { id: 'blocks', done: blocks.delivered, of: blocks.of },
  ];
  return goals.filter(({ of }) => of > 0);
}

/** The prohibitions of the course; and with a time limit alone: to hold out for that time. */
export function rulesOf({
  task,
  objects,
}: Pick<Scene, 'task' | 'objects'>): readonly ('noTouch' | 'avoidZones' | 'avoidSpikes' | 'holdOut')[] {
  return [
    ...(task.noTouch ? (['noTouch'] as const) : []),
    ...(objects.some(({ type }) => type === 'forbidden') ? (['avoidZones'] as const) : []),
    ...(!task.noTouch && objects.some(isSpiked) ? (['avoidSpikes'] as const) : []),
    ...(task.seconds !== null && goalsOf(verdictAtStart({ task, objects })).length === 0 ? (['holdOut'] as const) : []),
  ];
}

/** Whole seconds that are left, or `null` without a limit. The last one shows until it is over. */
export function secondsLeft(seconds: number | null, timeUs: number): number | null {
  return seconds === null ? null : Math.max(0, Math.ceil(seconds - timeUs / 1_000_000));
}

/** Where to look for what was touched: its middle, in world mm; `null` where nothing is known of it. */
export function placeOf(objects: readonly SceneObject[], id: string | null): Vec | null {
  const object = objects.find((one) => one.id === id);
  if (object === undefined) return null;
  if (object.type === 'wall') return { x: (object.from[0] + object.to[0]) / 2, y: (object.from[1] + object.to[1]) / 2 };
  if (object.type === 'stroke') {
    const middle = object.points[Math.floor(object.points.length / 2)];
    return middle === undefined ? null : { x: middle[0], y: middle[1] };
  }
  return { x: object.at[0], y: object.at[1] };
}
