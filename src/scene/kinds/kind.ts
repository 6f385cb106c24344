import { boundsOfOutline, overlapMm, type Bounds, type Outline } from '../outline';
import type { SceneObject } from '../scene';
import type { Unread } from './unread';

/** Common properties of all objects of a course. */
export interface AnyObject {
  readonly type: string;
  readonly id: string;
}

/** A kind of object as the course knows it: its form in a file, and where it is. */
export interface SceneKind<O extends AnyObject = SceneObject> {
  /** Its name in messages. */
  readonly name: string;
  /** Its properties in a file besides `id` and `type`. */
  readonly properties: readonly string[];
  /** Reads an unchecked one; what is wrong with it is noted in the reader. */
  read(given: Unread): O;
  /** Its properties in the form of a file, without defaults. */
  write(object: O): readonly string[];
  /** The outline of what a robot bumps into, in world mm (a mover: where it starts); `null` for what lies flat on the floor. */
  solid(object: O): Outline | null;
  /** The smallest rectangle along the axes around all of it. World mm. */
  bounds(object: O): Bounds;
  /** Whether a part of it lies within the arena's outline; for the round ends of strokes this errs towards yes. */
  reachesInto(object: O, arena: Outline): boolean;
}

/** The extent of a kind whose objects fill a convex outline. */
export const filling = <O extends AnyObject>(
  outline: (object: O) => Outline,
): Pick<SceneKind<O>, 'bounds' | 'reachesInto'> => ({
  bounds: (object) => boundsOfOutline(outline(object)),
  reachesInto: (object, arena) => overlapMm(outline(object), arena) > 0,
});

/** The extent of a kind whose objects fill a convex outline that a robot bumps into. */
export const standing = <O extends AnyObject>(
  outline: (object: O) => Outline,
): Pick<SceneKind<O>, 'solid' | 'bounds' | 'reachesInto'> => ({ solid: outline, ...filling(outline) });
