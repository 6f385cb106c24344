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

/** True if a thing is selected. */
export const includes = (selection: Selection, thing: Thing): boolean =>
  thing === null ? selection.robot : selection.ids.includes(thing);

/** How many things are selected. */
export const countOf = ({ ids, robot }: Selection): number => ids.length + (robot ? 1 : 0);

/** A selection with what a tap takes, or without it if all of it was selected. */
export function toggled(selection: Selection, taken: Selection): Selection {
  const isAll = taken.ids.every((id) => selection.ids.includes(id)) && (selection.robot || !taken.robot);
  if (!isAll) return joined(selection, taken);
  return { ids: selection.ids.filter((id) => !taken.ids.includes(id)), robot: selection.robot && !taken.robot };
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

/** The selected objects that may be changed: those that are not locked. */
export const freeObjects = (scene: Scene, selection: Selection): readonly SceneObject[] =>
  selectedObjects(scene, selection).filter(isFree);

const isFree = ({ lock }: SceneObject): boolean => lock === undefined;

/**
 * The selection that a tap on a thing makes: the thing with the members of its group, the locked ones if it is locked,
 * else the free ones. If some but not all of these are selected, somebody works within the group: then the thing alone.
 */
export function takenBy(scene: Scene, thing: Thing, { ids }: Selection): Selection {
  const members = thing === null ? [] : membersWith(scene, thing);
  const chosen = new Set(ids);
  const count = members.filter((id) => chosen.has(id)).length;
  return members.length < 2 || (count > 0 && count < members.length) ? only(thing) : { ids: members, robot: false };
}

/** The ids of an object and of the members of its group that are locked, or free, like it, in the order of painting. */
function membersWith({ objects }: Scene, id: string): readonly string[] {
  const object = objects.find((one) => one.id === id);
  if (object?.group === undefined) return [id];
  return objects.flatMap((one) => (one.group === object.group && one.lock === object.lock ? [one.id] : []));
}

/** All free objects of these and of their groups. */
function withGroups({ objects }: Scene, caught: readonly SceneObject[]): readonly string[] {
  const free = caught.filter(isFree);
  const groups = new Set(free.flatMap(({ group }) => group ?? []));
  if (groups.size === 0) return free.map(({ id }) => id);
  const chosen = new Set(free);
  return objects.flatMap((one) =>
    chosen.has(one) || (isFree(one) && one.group !== undefined && groups.has(one.group)) ? [one.id] : [],
  );
}

/** The objects that something catches, as far as they are free, with all of their groups. */
export const caughtBy = (scene: Scene, catches: (object: SceneObject) => boolean): readonly string[] =>
  withGroups(scene, scene.objects.filter(catches));

/** All objects that are not locked, and the robot's start. `hasRobot`: there is a robot to select. */
export const selectAll = (scene: Scene, hasRobot = true): Selection => ({
  ids: scene.objects.filter(isFree).map(({ id }) => id),
  robot: hasRobot,
});

/**
 * The things at a place, the best first: those on which it lies from top to bottom (the robot is the topmost), then
 * those within reach, the nearest first. Zones come last, because they are large and things stand on them.
 *
 * @param isCaught objects that count; left out: those that are not locked
 */
export function thingsAt(
  scene: Scene,
  place: Vec,
  reachMm: number,
  footprint: readonly Outline[] = [],
  isCaught: (object: SceneObject) => boolean = isFree,
): readonly Thing[] {
  const hits: { thing: Thing; zone: number; mm: number; height: number }[] = [];
  const toRobot = Math.min(
    Infinity,
    ...robotOutlines(scene.robot, footprint).map((part) => distanceToOutline(part, place)),
  );
  if (toRobot <= reachMm) hits.push({ thing: null, zone: 0, mm: toRobot, height: Infinity });
  scene.objects.forEach((object, index) => {
    if (!isCaught(object)) return;
    const mm = distanceTo(object, place, reachMm);
    if (mm === null) return;
    const { layer } = kindOf(object);
    hits.push({ thing: object.id, zone: layer === 0 ? 1 : 0, mm, height: layer * scene.objects.length + index });
  });
  return hits.sort((a, b) => a.zone - b.zone || a.mm - b.mm || b.height - a.height).map(({ thing }) => thing);
}

/** Everything free that an upright frame between two corners touches, with all of its groups. */
export function thingsIn(scene: Scene, from: Vec, to: Vec, footprint: readonly Outline[] = []): Selection {
  const frame = boundsOfOutline([from, to]);
  const outline = cornersOf(frame);
  return {
    ids: caughtBy(scene, (object) => meets(object, outline, frame)),
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

/** Takes the selected objects away; the robot's start and what is locked stay. `null` when nothing goes. */
export const removed = (scene: Scene, selection: Selection): SceneEdit | null =>
  removing(freeObjects(scene, selection).map(({ id }) => id));
