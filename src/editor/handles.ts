import type { Vec } from '#core/geometry';
import { directionOf, type Outline } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';
import { distanceMm, middleBetween, toVec, turned } from './plane';
import { boundsOfSelection, selectedObjects } from './selection';
import { boundsAround, distanceTo } from './shape';
import type { Handle, Selection } from './tools/tool';
import { middleOf } from './transform';

/** Reach for which handles stand when nobody says; in mm. */
const USUAL_REACH_MM = 12;

/**
 * The handles of what is selected. One thing: its ends, a corner that sizes it, a knob that turns it; several: one knob
 * that turns all. A knob's `id` is the one thing's, or the first one's of several.
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
  const objects = selectedObjects(scene, selection);
  const [first] = objects;
  const hasRobot = selection.robot && footprint.length > 0;
  if (objects.length + (hasRobot ? 1 : 0) > 1) {
    const around = boundsOfSelection(scene, selection, footprint);
    if (!around) return [];
    const at = { x: (around.minX + around.maxX) / 2, y: around.maxY + 2 * reachMm };
    return [{ kind: 'rotate', at, id: first?.id ?? null }];
  }
  if (first) return objectHandles(first, reachMm);
  return hasRobot ? [{ kind: 'rotate', at: aheadOfRobot(scene, footprint, reachMm), id: null }] : [];
}

function aheadOfRobot({ robot }: Scene, footprint: readonly Outline[], reachMm: number): Vec {
  const front = Math.max(...footprint.flatMap((part) => part.map(({ x }) => x))) * robot.scale + 2 * reachMm;
  return movedAlong(toVec(robot.at), turned({ x: 1, y: 0 }, robot.heading), front);
}

function objectHandles(object: SceneObject, reachMm: number): readonly Handle[] {
  const { id } = object;
  switch (object.type) {
    case 'wall':
      return [
        { kind: 'from', at: toVec(object.from), id },
        { kind: 'to', at: toVec(object.to), id },
        {
          kind: 'rotate',
          at: besideLine(toVec(object.from), toVec(object.to), object.thickness / 2 + 2 * reachMm),
          id,
        },
      ];
    case 'stroke': {
      const [first, last] = object.points;
      const around = boundsAround(object);
      if (object.points.length === 1 || !first) return [];
      if (object.points.length === 2 && last)
        return [
          { kind: 'from', at: toVec(first), id },
          { kind: 'to', at: toVec(last), id },
          { kind: 'rotate', at: besideLine(toVec(first), toVec(last), object.width / 2 + 2 * reachMm), id },
        ];
      return [{ kind: 'rotate', at: { x: middleOf(object).x, y: around.maxY + 2 * reachMm }, id }];
    }
    case 'label':
      return [{ kind: 'rotate', at: aboveBox(object, object.height, reachMm), id }];
    case 'mover':
      return [...boxHandles(object, reachMm), { kind: 'to', at: toVec(object.to), id }];
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return boxHandles(object, reachMm);
    default:
      return object satisfies never;
  }
}

function boxHandles(box: Extract<SceneObject, { size: unknown }>, reachMm: number): readonly Handle[] {
  const { x: cos, y: sin } = directionOf(box.turn);
  const [halfX, halfY] = [box.size[0] / 2, box.size[1] / 2];
  const corner = { x: box.at[0] + halfX * cos - halfY * sin, y: box.at[1] + halfX * sin + halfY * cos };
  return [
    { kind: 'size', at: corner, id: box.id },
    { kind: 'rotate', at: aboveBox(box, box.size[1], reachMm), id: box.id },
  ];
}

/** Above the middle of a box's own upper side. */
function aboveBox({ at, turn }: Extract<SceneObject, { turn: number }>, heightMm: number, reachMm: number): Vec {
  const { x: cos, y: sin } = directionOf(turn);
  return movedAlong(toVec(at), { x: -sin, y: cos }, heightMm / 2 + 2 * reachMm);
}

/** Beside the middle of a line, on its left. */
function besideLine(from: Vec, to: Vec, byMm: number): Vec {
  const length = distanceMm(from, to);
  if (length === 0) return from;
  return movedAlong(middleBetween(from, to), { x: -(to.y - from.y) / length, y: (to.x - from.x) / length }, byMm);
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

/** How far handles reach at this place: a quarter of the thing's extent where the place is on it. */
function reachOnBody(scene: Scene, selection: Selection, place: Vec, reachMm: number): number {
  const on = selectedObjects(scene, selection).find((object) => distanceTo(object, place, 0) !== null);
  return on ? Math.min(reachMm, extentMm(on) / 4) : reachMm;
}

/** The length of a line, the smaller side of a box. */
function extentMm(object: SceneObject): number {
  switch (object.type) {
    case 'wall':
      return distanceMm(toVec(object.from), toVec(object.to));
    case 'stroke':
    case 'label': {
      const { minX, minY, maxX, maxY } = boundsAround(object);
      return Math.max(maxX - minX, maxY - minY);
    }
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'mover':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return Math.min(...object.size);
    default:
      return object satisfies never;
  }
}
