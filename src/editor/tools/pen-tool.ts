import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import { boundsMeet, boundsOfOutline } from '#scene/outline';
import { sceneLimits, type Point, type Scene, type Stroke } from '#scene/scene';
import { FINGER_TOLERANCE_MM, simplified, TOLERANCE_MM } from '#scene/simplify';
import { endOf, isTap, startOf } from '../drag';
import { adding, roomIn } from '../edits';
import { freeIds } from '../ids';
import { chainMarks } from '../lines/corners';
import { endNear, puttingJoined, type Look } from '../lines/join-lines';
import { arcOf, isArcDone, penChain, polyline, roundShape } from '../lines/pen-shapes';
import { distanceMm, toPoint, toVec, within } from '../plane';
import { arenaBounds, grown } from '../bounds';
import { smooth } from './smooth';
import { isInArena, onGrid, snapMarks, snappedLine, strokeEnds, type SnappedLine } from '../snap';
import { withLure } from '../snap/attract';
import type { Drag, Mark, PenShape, Tool, ToolContext, ToolOptions } from './tool';

/**
 * Paints a line on the floor: as drawn, smoothed, straight, from click to click, an arc, or round a rectangle; a tap makes
 * a dot. Where it begins or ends on the end of a line that looks the same, the two become one.
 */
export const penTool: Tool = {
  id: 'pen',
  cursor: 'crosshair',
  edit(drag, context): SceneEdit | null {
    const { scene, options } = context;
    const points = pointsOf(drag, context);
    if (points.length === 0 || !isSeen(points, options.penWidth, scene)) return null;
    const id = freeIds(scene)('stroke');
    const stroke: Stroke = { type: 'stroke', id, points, width: options.penWidth, color: options.penColor };
    return drag.free ? adding(scene, [stroke]) : puttingJoined(scene, stroke);
  },
  ink: ({ options }) => (isDrawn(options) ? { width: options.penWidth, color: options.penColor } : null),
  goesOn(drag, context) {
    const { penShape } = context.options;
    if (penShape === 'arc') return !isArcDone(drag);
    return penShape === 'corners' && !penChain(drag, context).isDone;
  },
  marks(drag, context, isDown): readonly Mark[] {
    const { penShape } = context.options;
    if (penShape === 'corners' && drag.corners !== undefined) return chainMarks(drag, penChain(drag, context));
    if (drag.free || spansRectangle(penShape)) return [];
    if (penShape === 'straight') return snapMarks(straightLine(drag, context), !isTap(drag));
    const at = endNear(context.scene, lookOf(context.options), isDown ? endOf(drag) : startOf(drag), reachOf(drag));
    return at ? [{ type: 'snap', at: toVec(at) }] : [];
  },
};

const isDrawn = ({ penShape }: ToolOptions): boolean => penShape === 'free' || penShape === 'curve';
const spansRectangle = (shape: PenShape): boolean => shape === 'circle' || shape === 'oval' || shape === 'rounded';
const lookOf = ({ penWidth: width, penColor: color }: ToolOptions): Look => ({ width, color });

function pointsOf(drag: Drag, context: ToolContext): readonly Point[] {
  const { penShape, penWidth } = context.options;
  if (penShape === 'straight') return straightPoints(drag, context);
  if (penShape === 'corners') return polyline(drag, context);
  if (penShape === 'arc') return arcOf(drag, context);
  if (spansRectangle(penShape)) return isTap(drag) ? [toPoint(startOf(drag))] : roundShape(drag, context);
  // A short mark is what was drawn; only what is hidden under the pen's own width is a dot.
  if (isTap({ ...drag, reachMm: Math.min(drag.reachMm, penWidth / 2) })) return [toPoint(startOf(drag))];
  const line = attracted(closedLine(drag.path.map(kept), drag, penWidth), drag, context);
  return thinned(penShape === 'curve' ? smooth(line) : line, toleranceOf(drag), roomIn(context.scene).points);
}

/** A drawn line whose ends go to those of lines that look the same, so that they become one. */
function attracted(path: readonly Vec[], drag: Drag, { scene, options }: ToolContext): readonly Vec[] {
  if (drag.free) return path;
  const toEnd = (place: Vec): Vec => {
    const end = endNear(scene, lookOf(options), place, reachOf(drag));
    return end ? toVec(end) : place;
  };
  return path.map((place, index) => (index === 0 || index === path.length - 1 ? toEnd(place) : place));
}

/** Ends attract no farther than a line that comes back to its start is closed. */
const reachOf = ({ reachMm }: Drag): number => Math.min(reachMm, CLOSES_MM);

function straightPoints(drag: Drag, context: ToolContext): readonly Point[] {
  if (isTap(drag)) return [toPoint(drag.free ? startOf(drag) : onGrid(startOf(drag), drag.reachMm))];
  const { from, to } = straightLine(drag, context);
  return from[0] === to[0] && from[1] === to[1] ? [from] : [from, to];
}

function straightLine(drag: Drag, context: ToolContext): SnappedLine {
  const { scene } = context;
  const { reachMm, free, lure } = withLure(drag, context);
  const size = scene.size;
  if (!isInArena(startOf(drag), size, reachMm))
    return { from: toPoint(startOf(drag)), to: toPoint(startOf(drag)), snaps: [] };
  return snappedLine(startOf(drag), endOf(drag), { ends: strokeEnds(scene), walls: [] }, { size, reachMm, free, lure });
}

/** A place within what a course may hold. */
const kept = ({ x, y }: Vec): Vec => ({ x: within(x, sceneLimits.placeMm), y: within(y, sceneLimits.placeMm) });

/** Times of the reach that a line has to go away from its start before coming back means closing it. */
const AWAY = 3;

/** Largest distance at which an end closes a line, in mm, also on small screens. Chosen: twice the usual line. */
const CLOSES_MM = 40;

/** A line that comes back to its start is joined to it, so that a track is closed without a gap or a kink. */
function closedLine(path: readonly Vec[], { free, reachMm }: Drag, widthMm: number): readonly Vec[] {
  const [start] = path;
  const end = path[path.length - 1];
  // Nearer than its width the round ends meet already.
  const closesMm = Math.max(Math.min(reachMm, CLOSES_MM), widthMm);
  if (free || !start || !end || distanceMm(start, end) > closesMm) return path;
  return path.some((place) => distanceMm(start, place) > AWAY * closesMm) ? [...path, start] : path;
}

/** A line with as few points as needed, and never more than there is room for: then it is coarser, but has no gap. */
function thinned(line: readonly Vec[], finestMm: number, room: number): readonly Point[] {
  if (room < 2) return [];
  for (let toleranceMm = finestMm; ; toleranceMm *= 2) {
    const points = simplified(line, toleranceMm);
    if (points.length <= room) return points;
    if (toleranceMm > COARSEST_MM) return evenlyOf(points, room);
  }
}

/** The tolerance of a drag in mm. A finger reaches further than a mouse and trembles more: its tremble is left out. */
const toleranceOf = ({ reachMm }: Drag): number =>
  Math.min(FINGER_TOLERANCE_MM, Math.max(TOLERANCE_MM, reachMm / REACHES));

/** Chosen: 1.4 px of a finger at its usual reach of 22 px, half a pixel of a mouse. */
const REACHES = 16;

/** Coarsest simplification of a line; beyond it, only every n-th point is kept. */
const COARSEST_MM = 500;

const evenlyOf = (points: readonly Point[], count: number): readonly Point[] =>
  Array.from({ length: count }, (_, index) => points[Math.round((index * (points.length - 1)) / (count - 1))]).filter(
    (point) => point !== undefined,
  );

const isSeen = (points: readonly Point[], widthMm: number, { size }: Scene): boolean =>
  boundsMeet(grown(boundsOfOutline(points.map(([x, y]) => ({ x, y }))), widthMm / 2), arenaBounds(size));
