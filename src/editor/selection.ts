import type { Vec } from '#core/geometry';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, distanceToOutline, overlapMm, type Bounds, type Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { SceneEdit } from '#scene/edit';
import type { Scene, SceneObject } from '#scene/scene';
import { boundsAll, cornersOf } from './bounds';
import { removing } from './edits';
import { distanceTo, kindOf, meets } from './kinds/index';
import type { Selection } from './tools/tool';

/** Something that can be grabbed: an object by its id, or the robot's start (`null`). */
export type Thing = string | null;

/** A selection of just one thing. */
export const only = (thing: Thing): Selection =>
  thing === null ? { ids: [], robot: true } : { ids: [thing], robot: false };

/** Whether a thing is selected. */
export const includes = (selection: Selection, thing: Thing): boolean =>
  thing === null ? selection.robot : selection.ids.includes(thing);

/** How many things are selected. */
export const countOf = ({ ids, robot }: Selection): number => ids.length + (robot ? 1 : 0);

/** A selection with one thing more, or less if it was selected. */
export function toggled(selection: Selection, thing: Thing): Selection {
  if (thing === null) return { ...selection, robot: !selection.robot };
  const ids = selection.ids.includes(thing) ? selection.ids.filter((id) => id !== thing) : [...selection.ids, thing];
  return { ...selection, ids };
}

/** Both selections together. */
export const joined = (one: Selection, other: Selection): Selection => ({
  ids: [...new Set([...one.ids, ...other.ids])],
  robot: one.robot || other.robot,
});

/** The selected objects in the order of painting. */
export function selectedObjects(scene: Scene, { ids }: Selection): readonly SceneObject[] {
  if (ids.length === 0) return [];
  const chosen = new Set(ids);
  return scene.objects.filter(({ id }) => chosen.has(id));
}

/** All objects and the robot's start. `hasRobot`: there is a robot to select. */
export const selectAll = (scene: Scene, hasRobot = true): Selection => ({
  ids: scene.objects.map(({ id }) => id),
  robot: hasRobot,
});

/**
 * The things at a place, the best first: the robot, then things under it from top to bottom, then things within reach,
 * the nearest first. Zones come last, because they are large and things stand on them.
 */
export function thingsAt(
  scene: Scene,
  place: Vec,
  reachMm: number,
  footprint: readonly Outline[] = [],
): readonly Thing[] {
  const hits: { thing: Thing; zone: number; mm: number; height: number }[] = [];
  const toRobot = Math.min(
    Infinity,
    ...robotOutlines(scene.robot, footprint).map((part) => distanceToOutline(part, place)),
  );
  if (toRobot <= reachMm) hits.push({ thing: null, zone: 0, mm: toRobot, height: Infinity });
  scene.objects.forEach((object, index) => {
    const mm = distanceTo(object, place, reachMm);
    if (mm === null) return;
    const { layer } = kindOf(object);
    hits.push({ thing: object.id, zone: layer === 0 ? 1 : 0, mm, height: layer * scene.objects.length + index });
  });
  return hits.sort((a, b) => a.zone - b.zone || a.mm - b.mm || b.height - a.height).map(({ thing }) => thing);
}

/** Everything that an upright frame between two corners touches. */
export function thingsIn(scene: Scene, from: Vec, to: Vec, footprint: readonly Outline[] = []): Selection {
  const frame = boundsOfOutline([from, to]);
  const outline = cornersOf(frame);
  return {
    ids: scene.objects.filter((object) => meets(object, outline, frame)).map(({ id }) => id),
    robot: robotOutlines(scene.robot, footprint).some(
      (part) => boundsMeet(boundsOfOutline(part), frame) && overlapMm(part, outline) >= 0,
    ),
  };
}

/** The upright rectangle around what is selected; `null` when nothing is. */
export function boundsOfSelection(
  scene: Scene,
  selection: Selection,
  footprint: readonly Outline[] = [],
): Bounds | null {
  return boundsAll([
    ...selectedObjects(scene, selection).map(boundsOf),
    ...(selection.robot ? robotOutlines(scene.robot, footprint).map(boundsOfOutline) : []),
  ]);
}

/** Takes the selected objects away; the robot's start stays. `null` when no object is selected. */
export const removed = (scene: Scene, selection: Selection): SceneEdit | null =>
  removing(selectedObjects(scene, selection).map(({ id }) => id));
