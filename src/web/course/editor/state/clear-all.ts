import type { SceneEdit } from '#scene/edit';
import { sceneDefaults } from '#scene/scene';

/**
 * Removes all objects of a course and the picture of its floor in one step. Robot and size stay.
 *
 * @param isReady whether it is a ready-made course: its task and rules describe the removed objects, so they go, too.
 *   The name and an author's own texts stay.
 * @param isScored whether its line is scored: the tiles are gone with the line
 */
export const clearAll = (isReady: boolean, isScored = false): SceneEdit => {
  const changes = {
    background: null,
    ...(isReady && { description: '', task: sceneDefaults.task }),
    ...(isScored && { league: null }),
  };
  return { type: 'all', edits: [{ type: 'clear' }, { type: 'course', changes }] };
};
