import type { CanvasSize } from './view-transform';

/** A part of the canvas, in CSS px. */
export interface PxBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The whole canvas. */
export function wholeCanvas(canvas: CanvasSize): PxBox {
  return { left: 0, top: 0, width: canvas.widthPx, height: canvas.heightPx };
}

/** A square around a place. */
export function boxAround(at: { readonly x: number; readonly y: number }, radius: number): PxBox {
  return { left: at.x - radius, top: at.y - radius, width: 2 * radius, height: 2 * radius };
}

/** The smallest box around all of these; nothing at all gives an empty one. */
export function unionOf(boxes: readonly PxBox[]): PxBox {
  if (boxes.length === 0) return { left: 0, top: 0, width: 0, height: 0 };
  const left = Math.min(...boxes.map((box) => box.left));
  const top = Math.min(...boxes.map((box) => box.top));
  const right = Math.max(...boxes.map((box) => box.left + box.width));
  const bottom = Math.max(...boxes.map((box) => box.top + box.height));
  return { left, top, width: right - left, height: bottom - top };
}

/** Sizes of the window are multiples of this many px: a canvas with a new size every frame is slow. */
const STEP_PX = 64;
/** The contents can move at least this far in a new window, in px. */
const SLACK_PX = 32;
/** Share of a following window's room that is ahead; the rest is for trembling and turning. */
const AHEAD = 0.85;

/**
 * The place of the small canvas with the moving things: around everything to be drawn, on whole pixels, within the
 * canvas. A browser without a graphics card composes everything again that a changed canvas covers; a window of a
 * quarter of the arena makes that four times cheaper.
 *
 * It grows when it must, and shrinks only when it has become twice as large as it must be. It stays while everything
 * fits, and then moves ahead of the thing that left it: moving a canvas makes the browser sort all its layers again.
 */
export function movingWindow(
  content: PxBox,
  canvas: CanvasSize,
  ratio: number,
  before: PxBox | null,
  mayShrink = true,
): PxBox {
  const left = Math.max(0, content.left);
  const top = Math.max(0, content.top);
  const right = Math.min(canvas.widthPx, content.left + content.width);
  const bottom = Math.min(canvas.heightPx, content.top + content.height);
  const width = windowSide(right - left, canvas.widthPx, before?.width ?? 0, mayShrink);
  const height = windowSide(bottom - top, canvas.heightPx, before?.height ?? 0, mayShrink);
  const whole = (px: number): number => Math.floor(px * ratio) / ratio;
  const place = (from: number, to: number, side: number, canvasSide: number, last: number | undefined): number => {
    if (last !== undefined && last <= from && to <= last + side && last + side <= canvasSide) return last;
    const room = side - Math.max(0, to - from);
    return whole(Math.max(0, Math.min(from - room * roomBefore(from, to, side, last), canvasSide - side)));
  };
  return {
    left: place(left, right, width, canvas.widthPx, before?.left),
    top: place(top, bottom, height, canvas.heightPx, before?.top),
    width,
    height,
  };
}

/** Share of the room before the content: most of it in the direction of movement, half if that is unknown. */
function roomBefore(from: number, to: number, side: number, last: number | undefined): number {
  if (last === undefined) return 0.5;
  const [isBack, isOn] = [from < last, to > last + side];
  if (isBack === isOn) return 0.5;
  return isBack ? AHEAD : 1 - AHEAD;
}

function windowSide(needed: number, canvasSide: number, before: number, mayShrink: boolean): number {
  const snug = Math.min(canvasSide, Math.ceil((Math.max(0, needed) + SLACK_PX) / STEP_PX) * STEP_PX);
  const largest = mayShrink ? Math.min(canvasSide, Math.max(2 * snug, 4 * STEP_PX)) : canvasSide;
  return before >= snug && before <= largest ? before : snug;
}

/** Pictures in a row for which a window must have been too large before it shrinks: half a second. */
const PATIENCE = 30;

/**
 * A window that shrinks late: while somebody jumps through time, a long cone and a short one take turns, and a canvas
 * that changes its size each time costs more than all that is painted on it.
 */
export function patientWindow(): typeof movingWindow {
  let tooLarge = 0;
  return (content, canvas, ratio, before) => {
    const kept = movingWindow(content, canvas, ratio, before, false);
    const fitting = movingWindow(content, canvas, ratio, before);
    tooLarge = fitting.width < kept.width || fitting.height < kept.height ? tooLarge + 1 : 0;
    return tooLarge > PATIENCE ? fitting : kept;
  };
}

/** A thing moves this far on its own canvas until the canvas follows, in px. */
const ROOM_PX = 32;

/**
 * Place of the canvas of one moving thing: a square with room to move in, on whole pixels.
 *
 * @param last its place with this ratio; the same object is returned while the thing has room there
 */
export function roomyWindow({ left, top, width }: PxBox, ratio: number, last: PxBox | undefined): PxBox {
  const side = width + 2 * ROOM_PX;
  const hasRoom = (from: number, lastFrom: number): boolean => lastFrom <= from && from + width <= lastFrom + side;
  if (last?.width === side && hasRoom(left, last.left) && hasRoom(top, last.top)) return last;
  const whole = (px: number): number => Math.round((px - ROOM_PX) * ratio) / ratio;
  return { left: whole(left), top: whole(top), width: side, height: side };
}
