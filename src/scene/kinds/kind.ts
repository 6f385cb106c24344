import type { Rotation } from '../json-text';
import { boundsOfOutline, overlapMm, type Bounds, type Outline } from '../outline';
import type { SceneObject } from '../scene';

/** Common properties of all objects of a course. */
export interface AnyObject {
  readonly type: string;
  readonly id: string;
}

/** A kind of object as the course knows it: how it is written to a file, and where it is. It is read in `reading/`. */
export interface SceneKind<O extends AnyObject = SceneObject> {
  /** Its name in messages. */
  readonly name: string;
  /** Its own properties in the form of a file, without defaults. */
  write(object: O, rotation: Rotation): readonly string[];
  /** The convex parts of what a robot bumps into, in world mm (a mover: where it starts); none of what lies flat on the floor. */
  solid(object: O): readonly Outline[];
  /** The smallest rectangle along the axes around all of it. World mm. */
  bounds(object: O): Bounds;
  /** True if a part of it lies within the arena's outline; for the round ends of strokes this errs towards yes. */
  reachesInto(object: O, arena: Outline): boolean;
}

/** The extent of a kind whose objects fill a convex outline. */
export const filling = <O extends AnyObject>(
  outline: (object: O) => Outline,
): Pick<SceneKind<O>, 'bounds' | 'reachesInto'> => ({
  bounds: (object) => boundsOfOutline(outline(object)),
  reachesInto: (object, arena) => overlapMm(outline(object), arena) > 0,
});

/** The extent of a kind whose objects fill convex parts that a robot bumps into. */
export const standing = <O extends AnyObject>(
  parts: (object: O) => readonly Outline[],
): Pick<SceneKind<O>, 'solid' | 'bounds' | 'reachesInto'> => ({
  solid: parts,
  bounds: (object) => boundsOfOutline(parts(object).flat()),
  reachesInto: (object, arena) => parts(object).some((part) => overlapMm(part, arena) > 0),
});
