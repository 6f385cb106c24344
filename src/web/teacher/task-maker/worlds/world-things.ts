import type { ClassTask, WorldVariant } from '#check/task/task';
import { courseOfWorld } from '#check/task/world-course';
import { fullTurnDeg } from '#core/angle';
import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { kindOf, middleOf, movedBy } from '#editor/kinds/index';
import { directionDeg, steppedDeg, toVec, within } from '#editor/plane';
import { boundsOfSelection, only, thingsAt, type Thing } from '#editor/selection';
import { tagsStuckTo, withStuck } from '#editor/stuck';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Bounds, Outline } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';

import { objectEdit, withObject } from './world-objects';

/** The rectangle in which a small arena shows the robot, in mm at scale 1. Chosen: that of its picture. */
const ROBOT: Outline = [
  { x: -45, y: -45 },
  { x: 65, y: -45 },
  { x: 65, y: 45 },
  { x: -45, y: 45 },
];

/** The topmost thing at a place of a course, `null`: the robot; `undefined`: there is none. */
export const thingAt = (scene: Scene, place: Vec, reachMm: number): Thing | undefined =>
  thingsAt(scene, place, reachMm, [ROBOT])[0];

/** The rectangle around a thing; `null`: it is not there. */
export const frameOf = (scene: Scene, thing: Thing): Bounds | null => boundsOfSelection(scene, only(thing), [ROBOT]);

/** The thing before or after another one, in the order of the list: the robot, then the objects. */
export function nextThing({ objects }: Scene, thing: Thing, by: 1 | -1): Thing {
  const all: readonly Thing[] = [null, ...objects.filter(({ lock }) => lock === undefined).map(({ id }) => id)];
  return all[(all.indexOf(thing) + by + all.length) % all.length] ?? null;
}

/** The edit that moves a thing by whole mm; its middle stays in the arena. `null`: nothing changes, or no course has it there. */
export function movedThing(scene: Scene, thing: Thing, by: Vec): SceneEdit | null {
  const { robot, size } = scene;
  const object = objectIn(scene, thing);
  if (object === undefined && thing !== null) return null;
  const from = object === undefined ? { x: robot.at[0], y: robot.at[1] } : middleOf(object);
  const step = (axis: 'x' | 'y', most: number): number =>
    Math.round(within(from[axis] + by[axis], { min: 0, max: most }) - from[axis]);
  const [dx, dy] = [step('x', size[0]), step('y', size[1])];
  if (dx === 0 && dy === 0) return null;
  if (object !== undefined) return replaced(scene, movedBy(object, dx, dy));
  return { type: 'robot', robot: { at: [robot.at[0] + dx, robot.at[1] + dy], heading: robot.heading } };
}

/** The edit that turns a thing counter-clockwise about its middle; `null`: nothing changes, as with a circle. */
export function turnedThing(scene: Scene, thing: Thing, deg: number): SceneEdit | null {
  const { robot } = scene;
  if (thing === null) return { type: 'robot', robot: { at: robot.at, heading: fullTurnDeg(robot.heading + deg) } };
  const object = objectIn(scene, thing);
  if (object === undefined) return null;
  const turned = kindOf(object).turned(object, middleOf(object), deg);
  return isSame(turned, object) ? null : replaced(scene, turned);
}

/** The edit that makes the robot look at a place, in steps of so many degrees. */
export function facing({ robot: { at } }: Scene, place: Vec, stepDeg: number): SceneEdit {
  return { type: 'robot', robot: { at, heading: fullTurnDeg(steppedDeg(directionDeg(toVec(at), place), stepDeg)) } };
}

/** The course of a world; that of its task if the world cannot be made. */
export function sceneOfWorld({ project: { scene } }: ClassTask, world: WorldVariant): Scene {
  const made = courseOfWorld(scene, world);
  return 'scene' in made ? made.scene : scene;
}

/**
 * The edits of a world after a change of its list: `edits` has the object put down as it is made, or left out (`null`), and
 * the tags that are on it in that world go along. With one that was left out, those come back that are not there either.
 */
export function withRow(
  task: ClassTask,
  world: WorldVariant,
  edits: WorldVariant['edits'],
  id: string,
  made: SceneObject | null,
): WorldVariant['edits'] {
  const course = task.project.scene;
  const scene = sceneOfWorld(task, world);
  const isIn = (one: SceneObject): boolean => scene.objects.some((other) => other.id === one.id);
  const thing = course.objects.find((object) => object.id === id);
  const isBack = thing !== undefined && !isIn(thing);
  const tags = isBack ? tagsStuckTo(course, [id]).filter((tag) => !isIn(tag)) : [];
  const before = isBack ? { ...course, objects: [thing, ...tags] } : scene;
  let next = edits;
  for (const tag of tags) next = withObject(course, { ...world, edits: next }, tag.id, made === null ? null : tag);
  const own = objectEdit(id, made);
  return withEdit(task, { ...world, edits: next }, applyEdit(before, own), withStuck(before, own)).edits;
}

/** The difference of a hidden world after an edit of its course; `scene`: the world's course before it. */
export function withEdit(
  task: ClassTask,
  world: WorldVariant,
  scene: Scene,
  edit: SceneEdit,
): Pick<WorldVariant, 'start' | 'edits'> {
  const course = task.project.scene;
  const now = applyEdit(scene, edit);
  const gone = scene.objects.filter(({ id }) => !now.objects.some((object) => object.id === id));
  const changed = now.objects.filter((object) => !scene.objects.includes(object));
  let { edits } = world;
  for (const { id } of gone) edits = withObject(course, { ...world, edits }, id, null);
  for (const object of changed) edits = withObject(course, { ...world, edits }, object.id, object);
  const { at, heading } = now.robot;
  const isMoved = !isSame(at, scene.robot.at) || heading !== scene.robot.heading;
  const isOwn = isSame([at, heading], [course.robot.at, course.robot.heading]);
  return { edits, start: !isMoved ? world.start : isOwn ? null : { at, heading } };
}

const objectIn = ({ objects }: Scene, thing: Thing): SceneObject | undefined =>
  thing === null ? undefined : objects.find(({ id, lock }) => id === thing && lock === undefined);

function replaced(scene: Scene, object: SceneObject): SceneEdit | null {
  const edit = withStuck(scene, { type: 'replace', changes: [{ id: object.id, by: [object] }] });
  return editProblem(scene, edit) === null ? edit : null;
}
