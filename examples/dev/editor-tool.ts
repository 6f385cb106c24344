import { usualToolOptions } from '#editor/tools/tool-options';
import { nothingSelected } from '#editor/tools/tool';
import { tools } from '#editor/tools/tools';
import { applyEdit } from '#scene/edit';
import { defaultScene } from '#scene/scene';

import type { Print } from './example';

/** editor: a tool is a function from a drag to an edit. Here the wall tool, without a canvas and without a pointer. */
export function main(print: Print): void {
  const scene = defaultScene();
  const drag = {
    path: [
      { x: 203, y: 301 },
      { x: 598, y: 296 },
    ],
    free: false,
    adds: false,
    reachMm: 10,
  };
  const context = { scene, options: usualToolOptions, selection: nothingSelected, footprint: [] };
  const edit = tools.wall.edit(drag, context);
  if (edit === null) return;
  const [wall] = applyEdit(scene, edit).objects;
  print(JSON.stringify(wall));
}
