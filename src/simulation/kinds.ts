import type { SceneObject } from '#scene/scene';

/**
 * The effect of a change of an object during a run. `lasting`: it waits for the next start, since the robot may just be
 * driving against it; `movable`: it shows at once, and what was pushed stays where it is otherwise; `shown`: it shows at once.
 */
export type ChangeInRun = 'lasting' | 'movable' | 'shown';

/** The effect of a change of each kind of object. */
export const changesInRun: Readonly<Record<SceneObject['type'], ChangeInRun>> = {
  wall: 'lasting',
  block: 'movable',
  'fixed-block': 'lasting',
  stroke: 'shown',
  target: 'shown',
  checkpoint: 'shown',
  forbidden: 'shown',
  paper: 'shown',
  spikes: 'lasting',
  lamp: 'shown',
  barrier: 'lasting',
  tunnel: 'shown',
  tag: 'shown',
  mover: 'lasting',
  label: 'shown',
  start: 'lasting',
};

/** True if an object of a course changes in a run only with the next start; everything else does at once. */
export const isLasting = ({ type }: SceneObject): boolean => changesInRun[type] === 'lasting';

/** True if an object is a block that can be pushed. */
export const isMovable = ({ type }: SceneObject): boolean => changesInRun[type] === 'movable';

/** True if a robot that touches an object has failed: spikes, and movers with spikes. */
export const isSpiked = (object: SceneObject): boolean =>
  object.type === 'spikes' || (object.type === 'mover' && object.spiked);
