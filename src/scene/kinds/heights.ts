import type { SceneObject } from '../scene';

/** The kinds of objects that stand up from the floor. */
type Tall = Extract<SceneObject['type'], 'wall' | 'block' | 'fixed-block' | 'spikes' | 'mover'>;

/** Heights in mm of things whose file gives none. Chosen: ultrasonic sensors hear all of them, and no robot drives under. */
export const usualHeights: Readonly<Record<Tall, number>> = {
  wall: 250,
  block: 60,
  'fixed-block': 60,
  spikes: 50,
  mover: 100,
};

/** The top of a thing above the floor, in mm. */
export const heightOf = ({ type }: { readonly type: Tall }): number => usualHeights[type];
