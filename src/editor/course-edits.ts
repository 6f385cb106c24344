import type { SceneEdit } from '#scene/edit';
import type { Outline } from '#scene/outline';
import { placeInside } from '#scene/placement';
import { sceneLimits, type Point, type Scene } from '#scene/scene';
import { combined, startingAt } from './edits';
import { within } from './plane';

/** Gives the course a name; spaces around it are dropped. `null` when it is called so already. */
export function named(scene: Scene, name: string): SceneEdit | null {
  const short = name.trim().slice(0, sceneLimits.nameCharacters);
  return short === scene.name ? null : { type: 'course', changes: { name: short } };
}

/** Sets the course's description. `null` if it is the present one. */
export function described(scene: Scene, description: string): SceneEdit | null {
  const short = description.slice(0, sceneLimits.descriptionCharacters);
  return short === scene.description ? null : { type: 'course', changes: { description: short } };
}

/**
 * Gives the arena another size in mm. Its lower left corner and all objects stay where they are, the robot is brought
 * inside. `null` when it has that size already.
 */
export function withSize(scene: Scene, size: Point, footprint: readonly Outline[] = []): SceneEdit | null {
  const side = (mm: number): number => Math.round(within(mm, sceneLimits.sizeMm));
  const next: Point = [side(size[0]), side(size[1])];
  if (next[0] === scene.size[0] && next[1] === scene.size[1]) return null;
  return combined([
    { type: 'course', changes: { size: next } },
    startingAt(scene, { at: placeInside(scene.robot, next, footprint) }),
  ]);
}

/** Removes all objects; `null` if there are none. */
export const cleared = (scene: Scene): SceneEdit | null => (scene.objects.length === 0 ? null : { type: 'clear' });
