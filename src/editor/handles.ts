import type { Vec } from '#core/geometry';
import type { Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import { distanceTo, kindOf } from './kinds/index';
import { distanceMm, toVec, turned } from './plane';
import { boundsOfSelection, freeObjects } from './selection';
import { boundsHandles } from './size-handles';
import type { Handle, Selection } from './tools/tool';

/** Default reach for handles, in mm. */
const USUAL_REACH_MM = 12;

/**
 * The handles of what is selected. One thing: its ends, corners and sides that size it, a knob that turns it; several:
 * those of the rectangle around them, and one knob that turns all. Their `id` is the one thing's, or the first one's of
 * several.
 *
 * @param footprint convex parts of the robot at scale 1 in its own frame
 * @param reachMm the same as that of the drag, so that knobs stand clear of what they turn at every zoom
 */
export function handlesOf(
  scene: Scene,
  selection: Selection,
  footprint: readonly Outline[],
  reachMm: number = USUAL_REACH_MM,
): readonly Handle[] {
  const objects = freeObjects(scene, selection);
  const [first] = objects;
  const hasRobot = selection.robot && footprint.length > 0;
  if (objects.length + (hasRobot ? 1 : 0) > 1) {
    const around = boundsOfSelection(scene, selection, footprint);
    if (!around) return [];
    const id = first?.id ?? null;
    const at = { x: (around.minX + around.maxX) / 2, y: around.maxY + 2 * reachMm };
    return [...boundsHandles(around, id, reachMm), { kind: 'rotate', at, id }];
  }
  if (first) return kindOf(first).handles(first, reachMm);
  return hasRobot ? [{ kind: 'rotate', at: aheadOfRobot(scene, footprint, reachMm), id: null }] : [];
}

function aheadOfRobot({ robot }: Scene, footprint: readonly Outline[], reachMm: number): Vec {
  const front = Math.max(...footprint.flatMap((part) => part.map(({ x }) => x))) * robot.scale + 2 * reachMm;
  return movedAlong(toVec(robot.at), turned({ x: 1, y: 0 }, robot.heading), front);
}

const movedAlong = (place: Vec, direction: Vec, byMm: number): Vec => ({
  x: place.x + direction.x * byMm,
  y: place.y + direction.y * byMm,
});

/**
 * The handle that a press at a place takes hold of: the nearest within reach. On the selected thing itself handles
 * reach less far, so that a small thing can still be moved with a finger.
 */
export function handleAt(
  scene: Scene,
  selection: Selection,
  footprint: readonly Outline[],
  place: Vec,
  reachMm: number,
): Handle | null {
  let best: Handle | null = null;
  let bestMm = reachMm;
  const onBodyMm = reachOnBody(scene, selection, place, reachMm);
  for (const handle of handlesOf(scene, selection, footprint, reachMm)) {
    const mm = distanceMm(handle.at, place);
    if (mm > Math.min(bestMm, onBodyMm)) continue;
    best = handle;
    bestMm = mm;
  }
  return best;
}

/** Reach of handles at this place: a quarter of the thing's extent if the place is on it. */
function reachOnBody(scene: Scene, selection: Selection, place: Vec, reachMm: number): number {
  const on = freeObjects(scene, selection).find((object) => distanceTo(object, place, 0) !== null);
  return on ? Math.min(reachMm, kindOf(on).extentMm(on) / 4) : reachMm;
}
