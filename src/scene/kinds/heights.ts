import type { Barrier, Block, Mover, SceneObject, Spikes, Wall } from '../scene';

/** An object that stands up from the floor. */
export type StandingObject = Wall | Block | Spikes | Mover | Barrier;

/** Heights in mm of things whose file gives none. Chosen: ultrasonic sensors hear all of them, and no robot drives under. */
export const usualHeights: Readonly<Record<StandingObject['type'], number>> = {
  wall: 250,
  block: 60,
  'fixed-block': 60,
  spikes: 50,
  mover: 100,
  barrier: 100,
};

/** The top of a thing above the floor, in mm. */
export const heightOf = ({ type, height }: Pick<StandingObject, 'type' | 'height'>): number =>
  height ?? usualHeights[type];

/** True if an object stands up from the floor. */
export const isStanding = (object: SceneObject): object is StandingObject => object.type in usualHeights;

/** The height that an object has of its own, in mm; `null`: the usual one, or it lies flat on the floor. */
export const ownHeightOf = (object: SceneObject): number | null =>
  isStanding(object) ? (object.height ?? null) : null;

/** A thing is low if its own height is less than this, in mm. Chosen: the highest eye of a robot, a lidar's, looks over it. */
const LOW_MM = 100;

/** True if an object was made so low that some sensors look over it. */
export function isLowThing(object: SceneObject): boolean {
  const height = ownHeightOf(object);
  return height !== null && height < LOW_MM;
}

/** The property that makes a thing so high, in mm; `null` or the usual height of its kind: left out. */
export const heightProperty = (type: StandingObject['type'], mm: number | null): Pick<StandingObject, 'height'> =>
  mm === null || mm === usualHeights[type] ? {} : { height: mm };

/** A thing with another height, in mm; `null`: with the usual one of its kind. */
export function withHeight<O extends StandingObject>(object: O, mm: number | null): O {
  const { height: _height, ...rest } = object;
  return { ...rest, ...heightProperty(object.type, mm) } as O; // only its height is another
}
