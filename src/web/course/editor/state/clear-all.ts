import type { SceneEdit } from '#scene/edit';
import { sceneDefaults } from '#scene/scene';

/**
 * Removes all objects of a course in one step. Robot, size and picture stay.
 *
 * @param isReady whether it is a ready-made course: its task and rules describe the removed objects, so they go, too.
 *   The name and an author's own texts stay.
 * @param isScored whether its line is scored: the tiles are gone with the line
 */
export const clearAll = (isReady: boolean, isScored = false): SceneEdit => {
  const clear = { type: 'clear' } as const;
  if (!isReady && !isScored) return clear;
  const changes = {
    ...(isReady && { description: '', task: sceneDefaults.task }),
    ...(isScored && { league: null }),
  };
  return { type: 'all', edits: [clear, { type: 'course', changes }] };
};
