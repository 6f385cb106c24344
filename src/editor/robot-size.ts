import type { SceneEdit } from '#scene/edit';
import type { Outline } from '#scene/outline';
import { placeInside } from '#scene/placement';
import type { Scene } from '#scene/scene';
import { startingAt } from './edits';

/** Sizes of the robot relative to the real one that − and + lead through. */
export const robotSizes: readonly number[] = [0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3];

/** The next size in a direction, or `null` at the end. */
export function nextSize(scale: number, direction: 1 | -1): number | null {
  const next = direction > 0 ? robotSizes.find((size) => size > scale) : robotSizes.findLast((size) => size < scale);
  return next ?? null;
}

/** Makes the robot larger or smaller by a step; it stays inside the arena. `null` at the end. */
export function resized(scene: Scene, direction: 1 | -1, footprint: readonly Outline[] = []): SceneEdit | null {
  const scale = nextSize(scene.robot.scale, direction);
  if (scale === null) return null;
  return startingAt(scene, { scale, at: placeInside({ ...scene.robot, scale }, scene.size, footprint) });
}
