import type { SceneEdit } from '#scene/edit';
import { sceneDefaults } from '#scene/scene';

/**
 * Removes all objects of a course in one step. Robot, size and picture stay.
 *
 * @param isReady whether it is a ready-made course: its task and rules describe the removed objects, so they go, too.
 *   The name and an author's own texts stay.
 */
export const clearAll = (isReady: boolean): SceneEdit => {
  const clear = { type: 'clear' } as const;
  if (!isReady) return clear;
  const changes = { description: '', task: sceneDefaults.task };
  return { type: 'all', edits: [clear, { type: 'course', changes }] };
};
