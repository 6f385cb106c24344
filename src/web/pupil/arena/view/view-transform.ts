import type { Vec } from '#core/geometry';
import type { Bounds } from '#scene/outline';

/** Position of the arena on the canvas; the y axis points up in the arena and down on the canvas. */
export interface View {
  readonly pxPerMm: number;
  /** Place of the arena's lower left corner, in CSS px from the canvas's upper left corner. */
  readonly leftPx: number;
  readonly bottomPx: number;
}

/** An arena `[width, height]` in mm. */
export type ArenaSize = readonly [widthMm: number, heightMm: number];

/** A canvas in CSS px. */
export interface CanvasSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** From world mm to CSS px. */
export function toPx(view: View, at: Vec): Vec {
  return { x: view.leftPx + at.x * view.pxPerMm, y: view.bottomPx - at.y * view.pxPerMm };
}

/** From CSS px to world mm. */
export function toMm(view: View, at: Vec): Vec {
  return { x: (at.x - view.leftPx) / view.pxPerMm, y: (view.bottomPx - at.y) / view.pxPerMm };
}

/** Room for the rulers and the floor's shadow, in px; less on a narrow canvas. */
export function marginsPx(canvas: CanvasSize): { left: number; right: number; top: number; bottom: number } {
  const narrow = canvas.widthPx < 480; // chosen: a phone held upright
  return narrow ? { left: 30, right: 14, top: 12, bottom: 28 } : { left: 42, right: 26, top: 18, bottom: 36 };
}

/** The view that shows the whole arena, centred, as large as possible. */
export function fitView(arena: ArenaSize, canvas: CanvasSize): View {
  const margin = marginsPx(canvas);
  const freeWidth = Math.max(20, canvas.widthPx - margin.left - margin.right);
  const freeHeight = Math.max(20, canvas.heightPx - margin.top - margin.bottom);
  const pxPerMm = Math.min(freeWidth / arena[0], freeHeight / arena[1]);
  return {
    pxPerMm,
    leftPx: margin.left + (freeWidth - arena[0] * pxPerMm) / 2,
    bottomPx: margin.top + (freeHeight + arena[1] * pxPerMm) / 2,
  };
}

/** The zoom range, in px per mm: out to half the fitting size, in until a robot fills a screen. */
export function zoomLimits(arena: ArenaSize, canvas: CanvasSize): { min: number; max: number } {
  const fit = fitView(arena, canvas).pxPerMm;
  return { min: fit * 0.5, max: Math.max(fit * 8, 8) }; // chosen: 8 px per mm shows a robot at 640 px
}

/** The zoom relative to the fitting view, in percent: 100 shows the whole arena. */
export function zoomPercent(view: View, arena: ArenaSize, canvas: CanvasSize): number {
  return (view.pxPerMm / fitView(arena, canvas).pxPerMm) * 100;
}

/**
 * Zooms by a factor, within the limits; the place under `around` (CSS px) stays there as far as the arena's edge
 * allows.
 */
export function zoomView(view: View, factor: number, around: Vec, arena: ArenaSize, canvas: CanvasSize): View {
  const limits = zoomLimits(arena, canvas);
  const pxPerMm = Math.min(limits.max, Math.max(limits.min, view.pxPerMm * factor));
  const fixed = toMm(view, around);
  const moved = { pxPerMm, leftPx: around.x - fixed.x * pxPerMm, bottomPx: around.y + fixed.y * pxPerMm };
  return keptInSight(moved, arena, canvas);
}

/** Moves the picture by this many px, never beyond the arena's edge. */
export function panView(view: View, byPx: Vec, arena: ArenaSize, canvas: CanvasSize): View {
  return keptInSight(
    { pxPerMm: view.pxPerMm, leftPx: view.leftPx + byPx.x, bottomPx: view.bottomPx + byPx.y },
    arena,
    canvas,
  );
}

/** The same view when the canvas has another size: the centre stays in the centre. */
export function resizeView(view: View, arena: ArenaSize, before: CanvasSize, after: CanvasSize): View {
  const centre = toMm(view, { x: before.widthPx / 2, y: before.heightPx / 2 });
  const limits = zoomLimits(arena, after);
  const pxPerMm = Math.min(limits.max, Math.max(limits.min, view.pxPerMm));
  const moved = {
    pxPerMm,
    leftPx: after.widthPx / 2 - centre.x * pxPerMm,
    bottomPx: after.heightPx / 2 + centre.y * pxPerMm,
  };
  return keptInSight(moved, arena, after);
}

/**
 * The view in which a place is visible: the same if it is already, else with the place in its middle; zoomed out for a
 * place outside of the arena.
 */
export function placeView(view: View, at: Vec, arena: ArenaSize, canvas: CanvasSize): View {
  const px = toPx(view, at);
  const margin = marginsPx(canvas);
  const [rimX, rimY] = [canvas.widthPx / 10, canvas.heightPx / 10]; // chosen: at the very edge it is overlooked
  const shows =
    px.x >= margin.left + rimX &&
    px.x <= canvas.widthPx - margin.right - rimX &&
    px.y >= margin.top + rimY &&
    px.y <= canvas.heightPx - margin.bottom - rimY;
  if (shows) return view;
  const { pxPerMm } = view;
  if (!isWithin({ minX: at.x, minY: at.y, maxX: at.x, maxY: at.y }, arena)) {
    const around = {
      minX: at.x - OUTSIDE_MM,
      minY: at.y - OUTSIDE_MM,
      maxX: at.x + OUTSIDE_MM,
      maxY: at.y + OUTSIDE_MM,
    };
    return boxView(withArena([around], arena), arena, canvas);
  }
  const leftPx = canvas.widthPx / 2 - at.x * pxPerMm;
  return keptInSight({ pxPerMm, leftPx, bottomPx: canvas.heightPx / 2 + at.y * pxPerMm }, arena, canvas);
}

/** The margin shown around a place outside of the arena, in mm. Chosen: things there are about that large. */
const OUTSIDE_MM = 50;

/** The rectangle around the arena and others. */
export function withArena(boxes: readonly Bounds[], [width, height]: ArenaSize): Bounds {
  return {
    minX: Math.min(0, ...boxes.map(({ minX }) => minX)),
    minY: Math.min(0, ...boxes.map(({ minY }) => minY)),
    maxX: Math.max(width, ...boxes.map(({ maxX }) => maxX)),
    maxY: Math.max(height, ...boxes.map(({ maxY }) => maxY)),
  };
}

/** The view that shows a rectangle (world mm) as large as possible, also one outside of the arena. */
export function boxView(box: Bounds, arena: ArenaSize, canvas: CanvasSize): View {
  const margin = marginsPx(canvas);
  const widthPx = Math.max(20, canvas.widthPx - margin.left - margin.right);
  const heightPx = Math.max(20, canvas.heightPx - margin.top - margin.bottom);
  const fitting = Math.min(widthPx / Math.max(1, box.maxX - box.minX), heightPx / Math.max(1, box.maxY - box.minY));
  const pxPerMm = Math.min(zoomLimits(arena, canvas).max, fitting);
  const view = {
    pxPerMm,
    leftPx: margin.left + widthPx / 2 - ((box.minX + box.maxX) / 2) * pxPerMm,
    bottomPx: margin.top + heightPx / 2 + ((box.minY + box.maxY) / 2) * pxPerMm,
  };
  return isWithin(box, arena) ? keptInSight(view, arena, canvas) : view;
}

const isWithin = ({ minX, minY, maxX, maxY }: Bounds, [width, height]: ArenaSize): boolean =>
  minX >= 0 && minY >= 0 && maxX <= width && maxY <= height;

/**
 * The view moved towards showing a place in its middle third. Within the third it does not move: the picture rests
 * while the robot turns on the spot.
 *
 * @param share share of the remaining distance, 0 … 1
 * @param ratio canvas pixels per CSS px: the picture moves by whole pixels, or its fine lines would shimmer
 */
export function followView(
  view: View,
  at: Vec,
  arena: ArenaSize,
  canvas: CanvasSize,
  share: number,
  ratio: number,
): View {
  const px = toPx(view, at);
  const step = (place: number, length: number): number => {
    const beyond = place - Math.min((length * 2) / 3, Math.max(length / 3, place));
    return -Math.round(beyond * share * ratio) / ratio;
  };
  const by = { x: step(px.x, canvas.widthPx), y: step(px.y, canvas.heightPx) };
  if (by.x === 0 && by.y === 0) return view;
  const moved = panView(view, by, arena, canvas);
  return moved.leftPx === view.leftPx && moved.bottomPx === view.bottomPx ? view : moved;
}

/** Centres anything smaller than the canvas and prevents scrolling beyond the edges of anything larger. */
export function keptInSight(view: View, arena: ArenaSize, canvas: CanvasSize): View {
  const margin = marginsPx(canvas);
  const width = arena[0] * view.pxPerMm;
  const height = arena[1] * view.pxPerMm;
  return {
    pxPerMm: view.pxPerMm,
    leftPx: keep(view.leftPx, width, margin.left, canvas.widthPx - margin.right),
    bottomPx: keep(view.bottomPx - height, height, margin.top, canvas.heightPx - margin.bottom) + height,
  };
}

/** Start of a stretch of this length that fills `from` … `to`, or its middle if it is shorter. */
function keep(start: number, length: number, from: number, to: number): number {
  if (length <= to - from) return (from + to - length) / 2;
  return Math.min(from, Math.max(to - length, start));
}

/**
 * Canvas pixels per CSS px: the screen's own ratio, less when the canvas would get too large to fill 60 times a
 * second without a graphics card.
 */
export function backingRatio(canvas: CanvasSize, devicePixelRatio: number): number {
  const mostPixels = 5_000_000; // chosen: a tablet of 2360 × 1640 needs 3.9 million
  const area = Math.max(1, canvas.widthPx * canvas.heightPx);
  return Math.max(0.5, Math.min(devicePixelRatio, Math.sqrt(mostPixels / area)));
}
