import { sceneLimits, type Scene, type Zone } from '#scene/scene';
import { draggedBox, tappedMiddle } from '../box';
import { isTap, startOf } from '../drag';
import { addingOnce } from '../edits';
import { freeIds } from '../ids';
import { isInArena } from '../snap';
import { zoneSizes } from './tool-options';
import type { Tool } from './tool';

/** Marks a field on the floor: a tap one of the usual size, a drag the rectangle (or the ellipse in it). */
export const zoneTool: Tool = {
  id: 'zone',
  cursor: 'crosshair',
  edit(drag, { scene, options }) {
    if (!isInArena(startOf(drag), scene.size, drag.reachMm)) return null;
    const type = options.zone;
    const number = type === 'checkpoint' ? nextCheckpoint(scene) : 0;
    if (number === null) return null;
    const box = isTap(drag)
      ? { at: tappedMiddle(drag, scene.size), size: zoneSizes[type] }
      : draggedBox(drag, scene.size);
    const zone: Zone = {
      type,
      id: freeIds(scene)(type),
      ...box,
      turn: 0,
      round: options.zoneRound,
      number,
      blocks: type === 'target' ? options.zoneBlocks : 0,
    };
    return addingOnce(scene, zone);
  },
};

/** The number of the next checkpoint: one more than the highest, or the lowest free one; `null` when all are used. */
export function nextCheckpoint(scene: Scene, alsoTaken: readonly number[] = []): number | null {
  const taken = new Set(alsoTaken);
  for (const object of scene.objects) if (object.type === 'checkpoint') taken.add(object.number);
  const highest = Math.max(0, ...taken);
  const { min, max } = sceneLimits.checkpoint;
  if (highest < max) return highest + 1;
  for (let number = min; number <= max; number += 1) if (!taken.has(number)) return number;
  return null;
}
