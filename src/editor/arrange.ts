import { wrappedDeg } from '#core/angle';
import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import type { Bounds, Outline } from '#scene/outline';
import { placeInside } from '#scene/placement';
import { sceneLimits, type Point, type Scene, type SceneObject } from '#scene/scene';
import { boundsAll } from './bounds';
import { changing, combined, startingAt } from './edits';
import { kindOf, middleOf, movedBy } from './kinds/index';
import { middleBetween, toPoint, toVec, turnedAbout, within } from './plane';
import { freeObjects } from './selection';
import { withStuck } from './stuck';
import type { Selection } from './tools/tool';

/** This much of the moved things stays in the arena, so that they can be grabbed again. Chosen: a fingertip's width. */
const STAYS_MM = 10;

/**
 * Moves what is selected. Objects keep their arrangement and stay at least partly inside the arena; the robot stays
 * wholly inside. `null` when nothing moves.
 */
export function movingSelection(
  scene: Scene,
  selection: Selection,
  by: Vec,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const objects = freeObjects(scene, selection);
  const around = boundsAll(objects.map(boundsOf));
  const [dx, dy] = around ? stepInside(around, by, scene.size) : [0, 0];
  return combined([
    dx === 0 && dy === 0 ? null : changing(objects.map((object) => movedBy(object, dx, dy))),
    selection.robot ? robotMoved(scene, by, footprint) : null,
  ]);
}

/** Moves what is selected by whole mm, as the arrow keys do. */
export const nudged = (
  scene: Scene,
  selection: Selection,
  dx: number,
  dy: number,
  footprint: readonly Outline[] = [],
): SceneEdit | null => {
  const edit = movingSelection(scene, selection, { x: dx, y: dy }, footprint);
  return edit && withStuck(scene, edit);
};

/** The step in whole mm nearest to the wanted one that leaves a part of a rectangle in the arena. */
export function stepInside({ minX, minY, maxX, maxY }: Bounds, by: Vec, [width, height]: Point): Point {
  return [stepAlong(minX, maxX, by.x, width), stepAlong(minY, maxY, by.y, height)];
}

function stepAlong(min: number, max: number, step: number, length: number): number {
  const stays = Math.min(STAYS_MM, max - min);
  // A thing outside may come back by less than it takes to get in.
  const least = Math.max(Math.min(0, Math.ceil(stays - max)), Math.ceil(sceneLimits.placeMm.min - min));
  const most = Math.min(Math.max(0, Math.floor(length - stays - min)), Math.floor(sceneLimits.placeMm.max - max));
  if (least > most) return 0;
  return Math.round(within(step, { min: least, max: most })) + 0;
}

function robotMoved(scene: Scene, by: Vec, footprint: readonly Outline[]): SceneEdit | null {
  const { robot, size } = scene;
  const at = toPoint({ x: robot.at[0] + by.x, y: robot.at[1] + by.y });
  return startingAt(scene, { at: placeInside({ ...robot, at }, size, footprint) });
}

/** The middle that a selection turns about: of one thing its own, of several the middle of their middles. */
export function middleOfSelection(scene: Scene, selection: Selection): Vec | null {
  const middles = freeObjects(scene, selection).map(middleOf);
  if (selection.robot) middles.push(toVec(scene.robot.at));
  const [first] = middles;
  if (first === undefined) return null;
  if (middles.length === 1) return first;
  if (middles.length === 2) return middleBetween(first, middles[1] ?? first);
  const sum = middles.reduce((one, other) => ({ x: one.x + other.x, y: one.y + other.y }));
  return { x: sum.x / middles.length, y: sum.y / middles.length };
}

/** Turns what is selected counter-clockwise about its middle. */
export function turnedBy(
  scene: Scene,
  selection: Selection,
  angleDeg: number,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const middle = middleOfSelection(scene, selection);
  if (!middle || wrappedDeg(angleDeg) === 0) return null;
  const objects = freeObjects(scene, selection);
  const isOne = objects.length + (selection.robot ? 1 : 0) === 1;
  // About a whole place quarter turns of several things lose nothing.
  const pivot = isOne ? middle : toVec(toPoint(middle));
  const changed = objects.map((object) => kindOf(object).turned(object, pivot, angleDeg));
  return combined([
    changing(changed.filter((object, index) => !isUnturned(object, objects[index]))),
    selection.robot ? robotTurned(scene, pivot, angleDeg, footprint) : null,
  ]);
}

/** Turns what is selected by eighths of a full turn, counter-clockwise. */
export const turnedByEighths = (
  scene: Scene,
  selection: Selection,
  eighths: number,
  footprint: readonly Outline[] = [],
): SceneEdit | null => turnedBy(scene, selection, eighths * 45, footprint);

function robotTurned(scene: Scene, pivot: Vec, angleDeg: number, footprint: readonly Outline[]): SceneEdit | null {
  const { robot, size } = scene;
  const at = toPoint(turnedAbout(toVec(robot.at), pivot, angleDeg));
  const heading = wrappedDeg(robot.heading + angleDeg);
  return startingAt(scene, { at: placeInside({ ...robot, at, heading }, size, footprint), heading });
}

/** True if rounding to whole mm left a line where it was; what has an angle always counts as turned. */
const isUnturned = (object: SceneObject, before: SceneObject | undefined): boolean =>
  object === before || (!('angle' in object) && isSame(object, before));
