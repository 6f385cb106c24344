import type { SceneEdit } from '#scene/edit';
import type { Scene, SceneObject } from '#scene/scene';

import type { ArenaTool } from '../../course/editor/state/course-editor-model';

/** The tools that put a thing down. */
const MAKERS: Readonly<Record<SceneObject['type'], readonly ArenaTool[]>> = {
  wall: ['wall', 'maze'],
  block: ['block'],
  'fixed-block': ['block'],
  spikes: ['block'],
  mover: ['block'],
  stroke: ['pen'],
  target: ['zone'],
  checkpoint: ['zone'],
  forbidden: ['zone'],
  paper: ['zone'],
  lamp: ['block'],
  barrier: ['wall'],
  tunnel: ['zone'],
  tag: ['block'],
  label: ['label'],
  start: ['start'],
};

/**
 * Whether an edit is one that these tools make: by the keyboard, lists and menus nothing else is done either.
 *
 * @param scene the course before
 */
export function isMadeWith(hasTool: (tool: ArenaTool) => boolean, scene: Scene, edit: SceneEdit): boolean {
  const has = (...tools: readonly ArenaTool[]): boolean => tools.some(hasTool);
  const makes = ({ type }: SceneObject): boolean => has('select', ...MAKERS[type]);
  switch (edit.type) {
    case 'add':
      return edit.objects.every(makes);
    case 'remove':
      return has('select', 'eraser');
    case 'replace':
      return edit.changes.every(({ id, by }) => {
        const before = scene.objects.find((object) => object.id === id);
        return (
          has('eraser', 'rotate') ||
          (by.length > 0 ? by.every(makes) : has('select') || (before?.type === 'wall' && has('maze')))
        );
      });
    case 'robot':
      return has('select', 'rotate', 'start');
    case 'all':
      return edit.edits.every((part) => isMadeWith(hasTool, scene, part));
    default:
      return has('select'); // whoever has it builds courses
  }
}
