import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import { directionOf } from '#scene/outline';
import type { Mover, Point, Scene, SceneObject } from '#scene/scene';
import { middleOfSelection, selectionTurnsInEighths, turnedBy } from './arrange';
import { turningPoint } from './tools/block-tool';
import { boxSide } from './box';
import { endOf, startOf } from './drag';
import { changing } from './edits';
import { directionDeg, distanceMm, minus, plus, steppedDeg, toPoint, toVec, turned, wrappedDeg } from './plane';
import { gridMm, otherWalls, snappedTo, strokeEnds } from './snap';
import type { Drag, Handle, Selection, ToolContext } from './tools/tool';

/** What a drag that took hold of a handle amounts to. */
export function handleDragged(handle: Handle, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, selection, footprint } = context;
  if (handle.kind === 'rotate') {
    const angleDeg = draggedAngle(drag, scene, selection);
    return angleDeg === null ? null : turnedBy(scene, selection, angleDeg, footprint);
  }
  const object = scene.objects.find(({ id }) => id === handle.id);
  if (!object) return null;
  // What is taken hold of beside its middle keeps that distance.
  const place = plus(handle.at, minus(endOf(drag), startOf(drag)));
  const changed =
    handle.kind === 'size' ? sizedTo(object, place, drag) : endMovedTo(object, handle.kind, place, drag, scene);
  return changed && changing([changed]);
}

/**
 * By how much a drag turns a selection about its middle: steps of 45°, of 15° for the robot alone, of 1° when free and
 * nothing of it knows only eighths. `null` when there is nothing to turn or the drag has not left the middle.
 */
export function draggedAngle(drag: Drag, scene: Scene, selection: Selection): number | null {
  const pivot = middleOfSelection(scene, selection);
  const start = pivot && drag.path.find((place) => distanceMm(pivot, place) > drag.reachMm / 2);
  const end = endOf(drag);
  if (!pivot || !start || distanceMm(pivot, end) === 0) return null;
  const angleDeg = wrappedDeg(directionDeg(pivot, end) - directionDeg(pivot, start));
  return steppedDeg(angleDeg, stepDeg(drag, scene, selection));
}

function stepDeg({ free }: Drag, scene: Scene, selection: Selection): number {
  if (selectionTurnsInEighths(scene, selection)) return 45;
  if (free) return 1;
  return selection.robot && selection.ids.length === 0 ? 15 : 45;
}

function endMovedTo(object: SceneObject, end: 'from' | 'to', place: Vec, drag: Drag, scene: Scene): SceneObject | null {
  const { reachMm, free } = drag;
  const rules = { size: scene.size, reachMm, free };
  if (object.type === 'mover') return moverTurningAt(object, place, drag, scene.size);
  if (object.type === 'wall') {
    const stays = end === 'from' ? object.to : object.from;
    const to = snappedTo(stays, place, otherWalls(scene, object), rules);
    return isSame(stays, to) ? null : { ...object, [end]: to };
  }
  if (object.type === 'stroke') {
    const [first, last] = object.points;
    if (!first || !last) return null;
    const stays = end === 'from' ? last : first;
    const ends = strokeEnds(scene).filter((point) => point !== first && point !== last);
    const to = snappedTo(stays, place, { ends, walls: [] }, rules);
    if (isSame(stays, to)) return null;
    return { ...object, points: end === 'from' ? [to, stays] : [stays, to] };
  }
  return null;
}

function moverTurningAt(mover: Mover, place: Vec, drag: Drag, arena: Point): Mover {
  return { ...mover, to: turningPoint(place, mover.at, arena, drag) };
}

/** A box with its upper right corner (in its own frame) at a place; the corner opposite stays where it is. */
function sizedTo(object: SceneObject, place: Vec, { free, reachMm }: Drag): SceneObject | null {
  if (!('size' in object)) return null;
  const own = toOwnFrame(minus(place, toVec(object.at)), object.turn);
  const opposite = { x: -object.size[0] / 2, y: -object.size[1] / 2 };
  const side = (mm: number): number => boxSide(free ? mm : gridMm(mm, reachMm));
  const size: Point = [side(own.x - opposite.x), side(own.y - opposite.y)];
  if (isSame(size, object.size)) return null;
  const middle = { x: opposite.x + size[0] / 2, y: opposite.y + size[1] / 2 };
  const at = toPoint(plus(toVec(object.at), turned(middle, object.turn * 45)));
  if (object.type !== 'mover') return { ...object, at, size };
  const to = toPoint({ x: object.to[0] + at[0] - object.at[0], y: object.to[1] + at[1] - object.at[1] });
  return { ...object, at, to, size };
}

function toOwnFrame({ x, y }: Vec, turn: number): Vec {
  const { x: cos, y: sin } = directionOf(turn);
  return { x: x * cos + y * sin, y: y * cos - x * sin };
}

const isSame = (one: Point, other: Point): boolean => one[0] === other[0] && one[1] === other[1];
