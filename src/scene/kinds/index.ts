import { arenaOutline, boundsMeet, boundsOfOutline, type Bounds, type Outline } from '../outline';
import type { Point, SceneObject } from '../scene';
import { block, fixedBlock, spikes } from './block';
import type { SceneKind } from './kind';
import { barrier } from './barrier';
import { label } from './label';
import { lamp } from './lamp';
import { tag } from './tag';
import { tunnel } from './tunnel';
import { mover } from './mover';
import { paper } from './paper';
import { start } from './start';
import { stroke } from './stroke';
import { wall } from './wall';
import { checkpoint, forbidden, target } from './zone';

/** Every kind of object by its type. */
export const sceneKinds: Readonly<Record<SceneObject['type'], SceneKind>> = {
  wall,
  block,
  'fixed-block': fixedBlock,
  stroke,
  target,
  checkpoint,
  forbidden,
  paper,
  spikes,
  mover,
  lamp,
  barrier,
  tunnel,
  tag,
  label,
  start,
};

/** The kind of an object. */
export const kindOf = ({ type }: SceneObject): SceneKind => sceneKinds[type];

/** The convex parts of what a robot bumps into, in world mm; none of what lies flat on the floor. */
export const solidParts = (object: SceneObject): readonly Outline[] => kindOf(object).solid(object);

const knownBounds = new WeakMap<SceneObject, Bounds>();

/**
 * The smallest rectangle along the axes around an object, with the width of strokes and the track of movers. World mm.
 * Cached for the life of the object, which never changes: it is needed on every move of a pointer.
 */
export function boundsOf(object: SceneObject): Bounds {
  const known = knownBounds.get(object);
  if (known) return known;
  const bounds = kindOf(object).bounds(object);
  knownBounds.set(object, bounds);
  return bounds;
}

/** True if a part of an object lies in an arena of this size; for the round ends of strokes this errs towards yes. */
export function reachesInto(object: SceneObject, size: Point): boolean {
  const arena = arenaOutline(size);
  return boundsMeet(boundsOf(object), boundsOfOutline(arena)) && kindOf(object).reachesInto(object, arena);
}
