import type { Vec } from '#core/geometry';
import type { Palette } from '../model/palette';
import type { Trail } from '../../../session/run/trail';
import { sightPx } from '../picture/draw-floor';
import { toPx, type ArenaSize, type View } from '../view/view-transform';

/** Widths in px: the line, and its white casing, which separates it from dark lines. */
const LINE_PX = 2.4;
const CASING_PX = 5.2;

/** Points nearer to each other than this, in px, are drawn as one. */
const NEAR_PX = 1.5;

/** The pieces of a trail between its gaps, from a point on: each a list of px, x and y alternately. */
export function piecesOf(trail: Trail, from: number, view: View): number[][] {
  const pieces: number[][] = [];
  let piece: number[] = [];
  for (let i = from; i < trail.count; i += 1) {
    const x = trail.xyMm[2 * i] ?? NaN;
    if (Number.isNaN(x)) {
      if (piece.length > 0) pieces.push(piece);
      piece = [];
      continue;
    }
    const at = toPx(view, { x, y: trail.xyMm[2 * i + 1] ?? NaN });
    const before = piece.length;
    const isNear =
      before >= 4 &&
      Math.abs(at.x - (piece[before - 4] ?? 0)) < NEAR_PX &&
      Math.abs(at.y - (piece[before - 3] ?? 0)) < NEAR_PX;
    if (isNear) piece.length = before - 2; // the newest point stays: the line must reach it
    piece.push(at.x, at.y);
  }
  if (piece.length > 0) pieces.push(piece);
  return pieces;
}

/**
 * Draws a trail from one of its points on. The existing picture stays on top, so that a trail drawn piece by piece
 * looks like one drawn in a single pass: its casing never covers its line.
 */
export function drawTrail(
  context: CanvasRenderingContext2D,
  view: View,
  trail: Trail,
  from: number,
  palette: Palette,
): void {
  const pieces = piecesOf(trail, from, view);
  context.save();
  context.lineJoin = 'round';
  const path = new Path2D();
  for (const piece of pieces) {
    const [x = 0, y = 0, nextX = x, nextY = y] = piece;
    // Half a px back into the existing line: neither a gap nor, as with round ends, a knot.
    const back = 0.5 / (Math.hypot(nextX - x, nextY - y) || 1);
    path.moveTo(x - (nextX - x) * back, y - (nextY - y) * back);
    for (let i = 2; i < piece.length; i += 2) path.lineTo(piece[i] ?? 0, piece[i + 1] ?? 0);
  }
  context.globalCompositeOperation = 'destination-over';
  strokeWith(context, path, palette.traceCasing, CASING_PX);
  context.globalCompositeOperation = 'source-over';
  strokeWith(context, path, palette.trace, LINE_PX);
  context.restore();
  if (from === 0) drawStarts(context, pieces, palette);
}

/** A ring where the trail begins. */
function drawStarts(context: CanvasRenderingContext2D, pieces: readonly (readonly number[])[], palette: Palette): void {
  const [first] = pieces;
  if (first === undefined) return;
  context.fillStyle = palette.traceCasing;
  context.strokeStyle = palette.trace;
  context.lineWidth = LINE_PX;
  context.beginPath();
  context.arc(first[0] ?? 0, first[1] ?? 0, 4.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** Draws the newest part of a trail, which ends under the robot. */
export function drawTail(context: CanvasRenderingContext2D, pointsPx: readonly Vec[], palette: Palette): void {
  if (pointsPx.length < 2) return;
  context.save();
  context.lineJoin = 'round';
  const path = new Path2D();
  for (const point of pointsPx) path.lineTo(point.x, point.y);
  strokeWith(context, path, palette.traceCasing, CASING_PX);
  context.lineCap = 'round';
  strokeWith(context, path, palette.trace, LINE_PX);
  context.restore();
}

function strokeWith(context: CanvasRenderingContext2D, path: Path2D, color: string, width: number): void {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke(path);
}

/**
 * Shortest time between repaints of the canvas of the trails, in ms: it is large, and newer pieces are drawn with the
 * robots.
 */
const RENEW_MS = 250;

/** Everything that the canvas of the trails shows: any change repaints it. */
export interface TrailFrame {
  readonly canvas: HTMLCanvasElement;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly view: View;
  readonly arena: ArenaSize;
}

/** A trail in its colours. Another palette repaints the canvas. */
export interface ShownTrail {
  readonly trail: Trail;
  readonly palette: Palette;
}

/** The canvas with all of the trails but their newest points. */
export interface TrailLayer {
  /** Brings the canvas up to date when that is due. */
  paint(trails: readonly ShownTrail[], frame: TrailFrame, nowMs: number): void;
  /** The newest points of a trail that the canvas does not show yet, in px. */
  tail(trail: Trail, view: View): Vec[];
}

/**
 * Makes a layer that paints only the additions, four times a second. All trails share the canvas: each further one of
 * the arena's size would have to be copied and composed every time.
 */
export function createTrailLayer(): TrailLayer {
  let shown: readonly unknown[] = [];
  let paintedMs = 0;
  /** Number of points of a trail that the canvas shows. */
  const drawn = new Map<Trail, number>();
  const drawnOf = (trail: Trail): number => drawn.get(trail) ?? 0;
  return {
    paint(trails, frame, nowMs) {
      const wanted = [...frameOf(frame), ...trails.flatMap((one) => [one.trail, one.palette, one.trail.generation])];
      const isNew = !isSameList(shown, wanted);
      const hasMore = trails.some(({ trail }) => drawnOf(trail) !== trail.count);
      if (!isNew && (!hasMore || nowMs - paintedMs < RENEW_MS)) return;
      const context = frame.canvas.getContext('2d');
      if (context === null) return;
      if (isNew) {
        clear(context, frame);
        drawn.clear();
      }
      const sight = sightPx(frame.view, frame.arena, frame);
      context.save();
      context.beginPath();
      context.rect(sight.left, sight.top, sight.width, sight.height);
      context.clip();
      for (const { trail, palette } of trails) {
        if (drawnOf(trail) === trail.count) continue;
        drawTrail(context, frame.view, trail, Math.max(0, drawnOf(trail) - 1), palette);
        drawn.set(trail, trail.count);
      }
      context.restore();
      shown = wanted;
      paintedMs = nowMs;
    },
    tail(trail, view) {
      const points: Vec[] = [];
      for (let i = Math.max(0, drawnOf(trail) - 1); i < trail.count; i += 1) {
        const [x = NaN, y = NaN] = trail.xyMm.subarray(2 * i, 2 * i + 2);
        if (Number.isNaN(x)) points.length = 0;
        else points.push(toPx(view, { x, y }));
      }
      return points;
    },
  };
}

const frameOf = (frame: TrailFrame): readonly unknown[] => Object.values(frame);

const isSameList = (some: readonly unknown[], others: readonly unknown[]): boolean =>
  some.length === others.length && some.every((one, place) => one === others[place]);

function clear(context: CanvasRenderingContext2D, { canvas, widthPx, heightPx, ratio }: TrailFrame): void {
  canvas.width = Math.round(widthPx * ratio); // this clears it
  canvas.height = Math.round(heightPx * ratio);
  canvas.style.width = `${String(widthPx)}px`;
  canvas.style.height = `${String(heightPx)}px`;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
}
