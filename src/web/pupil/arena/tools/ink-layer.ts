import type { Vec } from '#core/geometry';
import { needsRim } from '#picture/kinds/stroke';
import type { PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import type { Ink } from './gesture';
import { toPx, type CanvasSize, type View } from '../view/view-transform';

/** The frame in which ink is drawn. */
export interface InkFrame {
  readonly view: View;
  readonly canvas: CanvasSize;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly palette: Palette;
  /** The floor, beyond which no ink shows. */
  readonly floor: PxBox;
}

/** Shortest time between repaints of the large canvas, in ms: newer ink is drawn on a small one. */
const RENEW_MS = 250;

/** The large canvas with all of a long line but its newest piece. */
export interface InkLayer {
  /** Brings the canvas up to date when that is due; without ink it is emptied. */
  paint(canvas: HTMLCanvasElement, ink: Ink | null, frame: InkFrame, nowMs: number): void;
  /** Number of the first place of the line that the canvas does not show yet. */
  readonly drawn: number;
}

/**
 * Makes a layer that paints only the additions: each piece of a line is painted twice, regardless of the line's length.
 */
export function createInkLayer(): InkLayer {
  let path: readonly Vec[] | null = null;
  let shown: InkFrame | null = null;
  let drawn = 0;
  let paintedMs = 0;
  const empty = (canvas: HTMLCanvasElement): void => {
    canvas.width = 0; // it costs nothing to put together
    path = null;
    shown = null;
    drawn = 0;
  };
  return {
    get drawn() {
      return drawn;
    },
    paint(canvas, ink, frame, nowMs) {
      if (ink === null) {
        if (path !== null || canvas.width > 0) empty(canvas);
        return;
      }
      if (ink.path !== path) {
        empty(canvas);
        path = ink.path;
        paintedMs = nowMs;
      }
      const isNew = shown !== null && !isSame(shown, frame);
      if (!isNew && (drawn === ink.path.length || nowMs - paintedMs < RENEW_MS)) return;
      if (shown === null || isNew) {
        drawn = 0;
        layOut(canvas, frame);
      }
      const context = canvas.getContext('2d');
      if (context === null) return;
      drawInk(context, ink, Math.max(0, drawn - 1), frame);
      drawn = ink.path.length;
      shown = frame;
      paintedMs = nowMs;
    },
  };
}

function isSame(one: InkFrame, other: InkFrame): boolean {
  return (
    one.view === other.view && one.canvas === other.canvas && one.ratio === other.ratio && one.palette === other.palette
  );
}

function layOut(canvas: HTMLCanvasElement, { canvas: size, ratio }: InkFrame): void {
  canvas.width = Math.round(size.widthPx * ratio); // this empties it
  canvas.height = Math.round(size.heightPx * ratio);
  canvas.style.width = `${String(size.widthPx)}px`;
  canvas.style.height = `${String(size.heightPx)}px`;
  canvas.getContext('2d')?.setTransform(ratio, 0, 0, ratio, 0, 0);
}

/** Places before the new piece that are painted once more, so that its rim does not cut into them. */
const AGAIN = 24;

/** Draws a line from one of its places on. */
export function drawInk(context: CanvasRenderingContext2D, ink: Ink, from: number, frame: InkFrame): void {
  const { view, palette, floor } = frame;
  const width = Math.max(1, ink.width * view.pxPerMm);
  context.save();
  context.beginPath();
  context.rect(floor.left, floor.top, floor.width, floor.height);
  context.clip();
  context.lineCap = 'round';
  context.lineJoin = 'round';
  if (needsRim(ink)) {
    trace(context, ink.path, from, view);
    context.strokeStyle = palette.strokeEdge;
    context.lineWidth = width + 2;
    context.stroke();
  }
  trace(context, ink.path, needsRim(ink) ? Math.max(0, from - AGAIN) : from, view);
  context.strokeStyle = palette.strokes[ink.color];
  context.lineWidth = width;
  context.stroke();
  context.restore();
}

function trace(context: CanvasRenderingContext2D, path: readonly Vec[], from: number, view: View): void {
  context.beginPath();
  for (let i = from; i < path.length; i += 1) {
    const place = path[i];
    if (place === undefined) continue;
    const at = toPx(view, place);
    if (i === from) context.moveTo(at.x, at.y);
    context.lineTo(at.x, at.y);
  }
}

/** The box around a line from one of its places on, in CSS px. */
export function inkBox(ink: Ink, from: number, view: View): PxBox {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = from; i < ink.path.length; i += 1) {
    const at = toPx(view, ink.path[i] ?? { x: 0, y: 0 });
    minX = Math.min(minX, at.x);
    minY = Math.min(minY, at.y);
    maxX = Math.max(maxX, at.x);
    maxY = Math.max(maxY, at.y);
  }
  const rim = (ink.width * view.pxPerMm) / 2 + 4;
  if (minX > maxX) return { left: 0, top: 0, width: 0, height: 0 };
  return { left: minX - rim, top: minY - rim, width: maxX - minX + 2 * rim, height: maxY - minY + 2 * rim };
}
