import { applyEdit } from '#scene/edit';
import { parseScene } from '#scene/parse';
import { defaultScene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import type { Print } from './example';

/** scene: a course is a value, an edit is data. Editing gives another course; the one before stays as it was. */
export function main(print: Print): void {
  const before = defaultScene();
  const after = applyEdit(before, {
    type: 'add',
    objects: [{ type: 'wall', id: 'wall-1', from: [200, 200], to: [800, 200], thickness: 20 }],
  });
  print(`${before.objects.length} objects before, ${after.objects.length} after`);
  const read = parseScene(serializeScene(after));
  print('scene' in read ? `read again: ${read.scene.objects.map(({ id }) => id).join(', ')}` : read.problem);
  const damaged = parseScene('{ "format": "parcours-scene", "version": 1, "size": [10, 900] }');
  print('scene' in damaged ? 'opened' : damaged.problem);
}
