import { isSame } from '#core/same';
import { applyEdit, type Replacement, type SceneEdit } from '#scene/edit';
import { countPoints, sceneLimits, type RobotStart, type Scene, type SceneObject, type Shaped } from '#scene/scene';

/** Several edits as one, in the shortest form; `null` for none. */
export function combined(edits: readonly (SceneEdit | null)[]): SceneEdit | null {
  const real = edits.filter((edit) => edit !== null);
  const [only] = real;
  if (only === undefined) return null;
  return real.length === 1 ? only : { type: 'all', edits: real };
}

/** Adds objects, unless the course is full or there are none. */
export function adding(scene: Scene, objects: readonly SceneObject[]): SceneEdit | null {
  const room = roomIn(scene);
  if (objects.length === 0 || objects.length > room.objects || pointsOf(objects) > room.points) return null;
  return { type: 'add', objects };
}

/**
 * Adds one object, unless an equal one is already at the same place: an accidental double tap would put two blocks into
 * one another, and show one.
 */
export function addingOnce(scene: Scene, object: SceneObject): SceneEdit | null {
  const isThere = scene.objects.some(
    (other) =>
      other.type === object.type &&
      'size' in other &&
      'size' in object &&
      isSame(other.at, object.at) &&
      isSame(formOf(other), formOf(object)) &&
      other.angle === object.angle,
  );
  return isThere ? null : adding(scene, [object]);
}

/** Size and shape. */
const formOf = ({ size, round, corners }: Pick<Shaped, 'size' | 'round' | 'corners'>) => [size, round, corners];

/** Takes objects away; `null` for none. */
export const removing = (ids: readonly string[]): SceneEdit | null =>
  ids.length === 0 ? null : { type: 'remove', ids };

/** Replaces objects by changed ones with the same ids; `null` if there are none. */
export const changing = (objects: readonly SceneObject[]): SceneEdit | null =>
  replacing(objects.map((object) => ({ id: object.id, by: [object] })));

/** Replaces objects; `null` when there is nothing to replace. */
export const replacing = (changes: readonly Replacement[]): SceneEdit | null =>
  changes.length === 0 ? null : { type: 'replace', changes };

/** Changes the robot's start; `null` when nothing changes. */
export function startingAt(scene: Scene, robot: Partial<RobotStart>): SceneEdit | null {
  const edit: SceneEdit = { type: 'robot', robot };
  return applyEdit(scene, edit) === scene ? null : edit;
}

/** How many more objects, and points of strokes and polygons, a course may hold. */
export function roomIn(scene: Scene): { readonly objects: number; readonly points: number } {
  return {
    objects: Math.max(0, sceneLimits.objects - scene.objects.length),
    points: Math.max(0, sceneLimits.points - pointsOf(scene.objects)),
  };
}

/** How many points some objects have together: those of strokes, and the corners of polygons. */
export const pointsOf = (objects: readonly SceneObject[]): number =>
  objects.reduce((points, object) => points + countPoints(object), 0);
