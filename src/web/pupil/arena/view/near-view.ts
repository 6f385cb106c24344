import { rotationRad } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import type { SceneObject } from '#scene/scene';
import { solidParts } from '#scene/kinds/index';
import { distanceToOutline } from '#scene/outline';

import { keptInSight, marginsPx, zoomLimits, type ArenaSize, type CanvasSize, type View } from './view-transform';

/** Seen around the robot at least, in mm. Chosen: the whole robot, and where it will be in the next second. */
const LEAST_MM = 160;
/** Seen beyond the nearest obstacle, in mm. Chosen by eye. */
const BEYOND_MM = 60;

/** Poses of things that have moved from their start, by their ids. */
type Moved = Readonly<Record<string, Pose>>;

/** The moved things in a picture of a run; `null`: there is no run, and everything is as in the course. */
export type MovedThings = { readonly blocks: Moved; readonly movers: Moved } | null;

/** Distance from a place to the nearest thing that a robot can bump into, including the edge of the arena, in mm. */
export function nearestMm(
  at: Vec,
  objects: readonly SceneObject[],
  [width, height]: ArenaSize,
  now: MovedThings = null,
): number {
  const toEdge = [at.x, at.y, width - at.x, height - at.y].map((mm) => Math.max(0, mm));
  const moved: Moved = { ...now?.blocks, ...now?.movers };
  const toObjects = objects.flatMap((object) => {
    const place = asBefore(at, object, moved[object.id]);
    return solidParts(object).map((part) => distanceToOutline(part, place));
  });
  return Math.min(...toEdge, ...toObjects);
}

/**
 * The place whose position relative to an object at its start is that of `at` to it now: pushed blocks may have any
 * angle.
 */
function asBefore(at: Vec, object: SceneObject, pose: Pose | undefined): Vec {
  if (pose === undefined || !('angle' in object)) return at;
  const turn = rotationRad(object.angle) - pose.headingRad;
  const [x, y] = [at.x - pose.xMm, at.y - pose.yMm];
  return {
    x: object.at[0] + x * Math.cos(turn) - y * Math.sin(turn),
    y: object.at[1] + x * Math.sin(turn) + y * Math.cos(turn),
  };
}

/** The view with a place in its middle and everything up to the nearest obstacle visible around it. */
export function nearView(at: Vec, nearest: number, arena: ArenaSize, canvas: CanvasSize): View {
  const margin = marginsPx(canvas);
  const widthPx = canvas.widthPx - margin.left - margin.right;
  const heightPx = canvas.heightPx - margin.top - margin.bottom;
  const aroundMm = Math.max(LEAST_MM, nearest + BEYOND_MM);
  const limits = zoomLimits(arena, canvas);
  const pxPerMm = Math.min(limits.max, Math.max(limits.min * 2, Math.min(widthPx, heightPx) / (2 * aroundMm)));
  const leftPx = margin.left + widthPx / 2 - at.x * pxPerMm;
  return keptInSight({ pxPerMm, leftPx, bottomPx: margin.top + heightPx / 2 + at.y * pxPerMm }, arena, canvas);
}
