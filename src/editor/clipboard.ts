import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, type Bounds, type Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { stepInside } from './arrange';
import { withoutLock } from './arranging/hold';
import { arenaBounds, boundsAll, shiftedBounds } from './bounds';
import { freeGroups, freeIds } from './ids';
import { kindOf, movedBy } from './kinds/index';
import { nextCheckpoint } from './kinds/zone';
import { noteMove, stepOfCopy } from './moves';
import { minus } from './plane';
import { selectedObjects } from './selection';
import { tagsStuckTo } from './stuck';
import type { Selection } from './tools/tool';

/** The selected objects, and the tags that are stuck to them, in the order of painting. */
function withTheirTags(scene: Scene, { ids, robot }: Selection): readonly SceneObject[] {
  const tags = tagsStuckTo(scene, ids).map(({ id }) => id);
  return selectedObjects(scene, { ids: [...ids, ...tags], robot });
}

/** Copied objects: plain data that can be pasted into any course. */
export interface Clip {
  readonly objects: readonly SceneObject[];
}

/** Objects put into a course, and the selection of just these. */
export interface Pasted {
  readonly edit: SceneEdit;
  readonly selection: Selection;
}

/** Least gap between a copy and its original, in mm; steps are rounded up to whole cm. Chosen: both can be grabbed. */
const GAP_MM = 10;

/** Distance of a copy that has no room beside its original, in mm. Chosen: two lines of the grid. */
const ASIDE_MM = 20;

/** How many places are tried on each side, each as far again. Chosen: across the largest arena. */
const MOST_STEPS = 100;

/** The selected objects as a clip; `null` when none is. The robot's start is not copied: there is only one. */
export function copied(scene: Scene, selection: Selection): Clip | null {
  const objects = withTheirTags(scene, selection);
  return objects.length === 0 ? null : { objects };
}

/**
 * Pastes copied objects into a course, with new ids and the next numbers for checkpoints: where they were copied from,
 * or with their middle at a place. If something of their layer is in the way, they go to the first free side.
 *
 * @returns an edit that a full course refuses; `null` if there is nothing to paste, or no number left for a checkpoint
 */
export function pasted(
  scene: Scene,
  { objects }: Clip,
  at: Vec | null = null,
  footprint: readonly Outline[] = [],
): Pasted | null {
  const around = boundsAll(objects.map(boundsOf));
  if (!around) return null;
  const [dx, dy]: Point = at === null ? [0, 0] : stepInside(around, stepTo(around, at), scene.size);
  const there = objects.map((object) => movedBy(object, dx, dy));
  return putMoved(scene, there, isFreeBy(scene, there, footprint)([0, 0]) ? [0, 0] : freeStep(scene, there, footprint));
}

/** Copies that were made, and the lower left corner around their originals, to go on by the same step. */
export interface Copies {
  readonly ids: readonly string[];
  readonly from: Vec;
}

/**
 * Copies what is selected to its first free side. If the last copy is selected, the new one goes on by the step between
 * that one and its original.
 */
export function duplicated(
  scene: Scene,
  selection: Selection,
  last: Copies | null = null,
  footprint: readonly Outline[] = [],
): (Pasted & { readonly copies: Copies }) | null {
  const objects = withTheirTags(scene, selection);
  const around = boundsAll(objects.map(boundsOf));
  if (!around) return null;
  const from = { x: around.minX, y: around.minY };
  const isLast = last !== null && isSame([...last.ids].sort(), [...selection.ids].sort());
  const [dx, dy]: Point = isLast ? stepInside(around, minus(from, last.from), scene.size) : [0, 0];
  const made = putMoved(scene, objects, dx === 0 && dy === 0 ? freeStep(scene, objects, footprint) : [dx, dy]);
  return made && { ...made, copies: { ids: made.selection.ids, from } };
}

/** Copies what is selected, moved by a step. `null` if the copies would lie exactly on their originals. */
export function copiedBy(scene: Scene, selection: Selection, by: Vec): Pasted | null {
  const objects = withTheirTags(scene, selection);
  const around = boundsAll(objects.map(boundsOf));
  if (!around) return null;
  const step = stepInside(around, by, scene.size);
  return step[0] === 0 && step[1] === 0 ? null : putMoved(scene, objects, step);
}

/** The copies that an edit makes of things that are there, all by the same step, as Alt-drag does; `null`: it makes none. */
export function copiesMade({ objects: there }: Scene, edit: SceneEdit): Copies | null {
  const made = edit.type === 'add' ? edit.objects : [];
  const around = boundsAll(made.map(boundsOf));
  const [step, ...others] = made.map((copy) => stepOfCopy(copy, there));
  if (!around || !step || !others.every((other) => isSame(other, step))) return null;
  return { ids: made.map(({ id }) => id), from: { x: around.minX - step.x, y: around.minY - step.y } };
}

/** The step that brings the middle of a rectangle to a place, in whole cm: what lies on the grid stays on it. */
const stepTo = ({ minX, minY, maxX, maxY }: Bounds, { x, y }: Vec): Vec => ({
  x: tens(x - (minX + maxX) / 2),
  y: tens(y - (minY + maxY) / 2),
});

const tens = (mm: number): number => Math.round(mm / 10) * 10;

/** The step to the nearest free place on the first side that has one; a little aside if none has. */
function freeStep(scene: Scene, objects: readonly SceneObject[], footprint: readonly Outline[]): Point {
  const around = boundsAll(objects.map(boundsOf));
  if (!around) return [0, 0];
  const arena = arenaBounds(scene.size);
  const isFree = isFreeBy(scene, objects, footprint);
  for (const [x, y] of sidesOf(around)) {
    for (let count = 1; count <= MOST_STEPS; count += 1) {
      const step: Point = [x * count, y * count];
      if (!holds(arena, shiftedBounds(around, step))) break;
      if (isFree(step)) return step;
    }
  }
  return stepInside(around, { x: ASIDE_MM, y: -ASIDE_MM }, scene.size);
}

/** The steps beside something; a copy of a level line goes below it before it goes behind its end. */
function sidesOf({ minX, minY, maxX, maxY }: Bounds): readonly Point[] {
  const [width, height] = [maxX - minX, maxY - minY];
  const across = Math.ceil((width + GAP_MM) / 10) * 10;
  const along = Math.ceil((height + GAP_MM) / 10) * 10;
  const level: readonly Point[] = [
    [across, 0],
    [-across, 0],
  ];
  const upright: readonly Point[] = [
    [0, -along],
    [0, along],
  ];
  return width > 2 * height ? [...upright, ...level] : [...level, ...upright];
}

const holds = (arena: Bounds, { minX, minY, maxX, maxY }: Bounds): boolean =>
  minX >= arena.minX && minY >= arena.minY && maxX <= arena.maxX && maxY <= arena.maxY;

/** The layer of things that stand on the floor, as the robot does. */
const STANDING = 3;

/** A test that is true if objects, moved by a step, meet nothing of their own layer there. */
function isFreeBy(
  scene: Scene,
  objects: readonly SceneObject[],
  footprint: readonly Outline[],
): (step: Point) => boolean {
  const sizes = objects.map((object) => ({ layer: kindOf(object).layer, around: boundsOf(object) }));
  const all = boundsAll(sizes.map(({ around }) => around));
  const taken = [
    ...scene.objects.map((object) => ({ layer: kindOf(object).layer, around: boundsOf(object) })),
    ...robotOutlines(scene.robot, footprint).map((part) => ({ layer: STANDING, around: boundsOfOutline(part) })),
  ];
  return (step) => {
    // Few things come near, however many are copied.
    const near = all ? taken.filter(({ around }) => boundsMeet(around, shiftedBounds(all, step))) : [];
    return !sizes.some(({ layer, around }) => {
      const there = shiftedBounds(around, step);
      return near.some((other) => other.layer === layer && boundsMeet(other.around, there));
    });
  };
}

/** Gives the new name of a group for its copies: they are a group of their own. */
function groupsOfCopies(scene: Scene): (group: string) => string {
  const names = new Map<string, string>();
  const freeGroup = freeGroups(scene);
  return (group) => {
    const name = names.get(group) ?? freeGroup();
    names.set(group, name);
    return name;
  };
}

/** Puts copies of objects into a course, moved by a step, as a selection of their own. */
export function putMoved(scene: Scene, originals: readonly SceneObject[], [dx, dy]: Point): Pasted | null {
  const freeId = freeIds(scene);
  const groupOf = groupsOfCopies(scene);
  const numbers: number[] = [];
  const objects: SceneObject[] = [];
  for (const original of originals) {
    const copy: SceneObject = {
      ...withoutLock(movedBy(original, dx, dy)), // it can be put into its place
      id: freeId(original.type),
      ...(original.group === undefined ? {} : { group: groupOf(original.group) }),
    };
    if (copy.type !== 'checkpoint') {
      objects.push(noteMove(original, copy, dx, dy)); // figures tell how far it is from its original
      continue;
    }
    const number = nextCheckpoint(scene, numbers);
    if (number === null) return null;
    numbers.push(number);
    objects.push({ ...copy, number });
  }
  return { edit: { type: 'add', objects }, selection: { ids: objects.map(({ id }) => id), robot: false } };
}
