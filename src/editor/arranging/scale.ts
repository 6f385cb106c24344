import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import type { Bounds, Outline } from '#scene/outline';
import { placeInside } from '#scene/placement';
import type { Point, Scene } from '#scene/scene';
import { changing, combined, startingAt } from '../edits';
import { kindOf } from '../kinds/index';
import { scaledPoint } from '../kinds/kind';
import { boundsOfSelection, freeObjects } from '../selection';
import { snappedPlace } from '../snap';
import type { Drag, Selection, ToolContext } from '../tools/tool';

/** The least extent of what is made smaller, in mm. Chosen: it can still be seen and grabbed. */
const SMALLEST_MM = 10;

/** Makes what is selected larger or smaller about a place; the robot keeps its size and goes along. */
export function scaledBy(
  scene: Scene,
  selection: Selection,
  about: Vec,
  factor: Vec,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  if (factor.x === 1 && factor.y === 1) return null;
  const objects = freeObjects(scene, selection);
  const { robot, size } = scene;
  const at = scaledPoint(robot.at, about, factor);
  return combined([
    changing(objects.map((object) => kindOf(object).scaled(object, about, factor) ?? object)),
    selection.robot ? startingAt(scene, { at: placeInside({ ...robot, at }, size, footprint) }) : null,
  ]);
}

/** Scales a selection so that a corner or side of the upright rectangle around it comes to a place. */
export function sizedTogether(side: Point, place: Vec, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, selection, footprint } = context;
  const around = boundsOfSelection(scene, selection, footprint);
  if (!around) return null;
  const isFromMiddle = drag.alt === true;
  const about = {
    x: staying(around.minX, around.maxX, side[0], isFromMiddle),
    y: staying(around.minY, around.maxY, side[1], isFromMiddle),
  };
  return scaledBy(
    scene,
    selection,
    about,
    factorOf(around, side, { about, place: snappedPlace(place, drag) }, drag.keeps === true),
    footprint,
  );
}

/** The place that stays: opposite of what is dragged, or the middle. */
function staying(min: number, max: number, side: number, isFromMiddle: boolean): number {
  if (side === 0 || isFromMiddle) return (min + max) / 2;
  return side < 0 ? max : min;
}

function factorOf(
  { minX, minY, maxX, maxY }: Bounds,
  side: Point,
  { about, place }: { readonly about: Vec; readonly place: Vec },
  keeps: boolean,
): Vec {
  const x = factorAlong(side[0] < 0 ? minX : maxX, side[0], [about.x, place.x]);
  const y = factorAlong(side[1] < 0 ? minY : maxY, side[1], [about.y, place.y]);
  if (!keeps) return { x, y };
  const both = side[0] === 0 ? y : side[1] === 0 ? x : Math.max(x, y);
  return { x: both, y: both };
}

function factorAlong(edge: number, side: number, [about, place]: Point): number {
  const before = (edge - about) * side;
  if (side === 0 || before < SMALLEST_MM / 2) return 1;
  const after = (place - about) * side;
  return Math.max(Math.min(SMALLEST_MM, before), after) / before;
}
