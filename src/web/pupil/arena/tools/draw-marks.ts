import type { Vec } from '#core/geometry';
import type { Handle, Mark } from '#editor/tools/tool';
import type { SceneObject } from '#scene/scene';
import { mdiRotateRight } from '@mdi/js';
import { once } from '#core/memo';
import { drawDistance, drawGuide } from './draw-guides';
import { outlinePath } from '../picture/draw-outline';
import type { Palette } from '../model/palette';
import { toPx, type View } from '../view/view-transform';
import type { MarkFrame } from './mark-frame';

/** Draws a mark of a tool in use. */
export function drawMark(context: CanvasRenderingContext2D, frame: MarkFrame, mark: Mark): void {
  const { view, palette } = frame;
  context.save();
  switch (mark.type) {
    case 'frame':
      drawFrame(context, toPx(view, mark.from), toPx(view, mark.to), palette);
      break;
    case 'lasso':
      drawLasso(context, view, mark.path, palette);
      break;
    case 'measure':
      drawMeasure(context, frame, mark.from, mark.to);
      break;
    case 'snap':
      cased(context, palette.hand, 2.5, () => circle(context, toPx(view, mark.at), 8));
      break;
    case 'point':
      drawPoint(context, toPx(view, mark.at), mark.isNew, palette);
      break;
    case 'eraser':
      context.fillStyle = 'rgba(255, 255, 255, 0.55)';
      circle(context, toPx(view, mark.at), Math.max(2, mark.radiusMm * view.pxPerMm));
      context.fill();
      cased(context, palette.wall, 1.5, () => undefined);
      break;
    case 'goes':
      context.fillStyle = palette.forbiddenFill;
      cased(context, palette.forbidden, 2.5, () => outlinePath(context, view, mark.object, 3));
      context.fill();
      break;
    case 'guide':
      drawGuide(context, frame, mark);
      break;
    case 'distance':
      drawDistance(context, frame, mark);
      break;
    case 'grid':
      drawGrid(context, frame, mark);
      break;
    default:
      mark satisfies never;
  }
  context.restore();
}

function drawFrame(context: CanvasRenderingContext2D, from: Vec, to: Vec, palette: Palette): void {
  context.fillStyle = palette.targetFill;
  context.beginPath();
  context.rect(Math.min(from.x, to.x), Math.min(from.y, to.y), Math.abs(to.x - from.x), Math.abs(to.y - from.y));
  context.fill();
  context.setLineDash([5, 4]);
  cased(context, palette.target, 1.5, () => undefined);
}

function drawLasso(context: CanvasRenderingContext2D, view: View, path: readonly Vec[], palette: Palette): void {
  context.fillStyle = palette.targetFill;
  context.lineJoin = 'round';
  context.beginPath();
  for (const place of path) {
    const at = toPx(view, place);
    context.lineTo(at.x, at.y);
  }
  context.closePath();
  context.fill();
  context.setLineDash([5, 4]);
  cased(context, palette.target, 1.5, () => undefined);
}

function drawMeasure(context: CanvasRenderingContext2D, frame: MarkFrame, fromMm: Vec, toMm: Vec): void {
  const { view, palette } = frame;
  const from = toPx(view, fromMm);
  const to = toPx(view, toMm);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const across = length < 1 ? { x: 0, y: 1 } : { x: -(to.y - from.y) / length, y: (to.x - from.x) / length };
  context.lineCap = 'round';
  cased(context, palette.hand, 2.5, () => {
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
    for (const end of [from, to]) {
      context.moveTo(end.x - across.x * 9, end.y - across.y * 9);
      context.lineTo(end.x + across.x * 9, end.y + across.y * 9);
    }
  });
}

/** Draws a point of a line as a ring; a small pale one where a new point can be drawn out. */
function drawPoint(context: CanvasRenderingContext2D, at: Vec, isNew: boolean, palette: Palette): void {
  context.globalAlpha = isNew ? 0.75 : 1;
  context.fillStyle = palette.handGround;
  circle(context, at, isNew ? 3.5 : HANDLE_PX);
  context.fill();
  context.strokeStyle = palette.hand;
  context.lineWidth = isNew ? 1.5 : 2;
  context.stroke();
}

/** Draws the corners of the grid of a maze all over the arena, and the edge that a tap changes. */
function drawGrid(context: CanvasRenderingContext2D, frame: MarkFrame, mark: Extract<Mark, { type: 'grid' }>): void {
  const { view, arena, palette } = frame;
  const { cellMm, edge } = mark;
  const [width, height] = arena;
  context.fillStyle = palette.target;
  const radius = Math.min(4, Math.max(2, cellMm * view.pxPerMm * 0.03));
  context.beginPath();
  for (let x = 0; x <= width; x += cellMm) {
    for (let y = 0; y <= height; y += cellMm) {
      const at = toPx(view, { x, y });
      context.moveTo(at.x + radius, at.y);
      context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    }
  }
  context.fill();
  if (edge === null) return;
  const [from, to] = [toPx(view, edge[0]), toPx(view, edge[1])];
  context.lineCap = 'round';
  context.globalAlpha = 0.75;
  cased(context, palette.hand, 5, () => {
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
  });
}

/** Strokes a path in a colour with a white rim, so that it is seen on any ground. */
function cased(context: CanvasRenderingContext2D, color: string, width: number, path: () => void): void {
  path();
  context.strokeStyle = 'rgba(255, 255, 255, 0.85)';
  context.lineWidth = width + 3;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}

function circle(context: CanvasRenderingContext2D, at: Vec, radius: number): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
}

/** Draws the frame around a selected object. */
export function drawSelected(context: CanvasRenderingContext2D, frame: MarkFrame, object: SceneObject): void {
  const { view, palette } = frame;
  context.save();
  context.lineJoin = 'round';
  if (object.type === 'stroke') {
    context.lineCap = 'round';
    outlinePath(context, view, object, 0);
    context.globalAlpha = 0.85;
    context.strokeStyle = '#fff';
    context.lineWidth = 4.5;
    context.stroke();
    context.globalAlpha = 1;
    context.setLineDash([7, 6]);
    context.strokeStyle = palette.hand;
    context.lineWidth = 2.5;
    context.stroke();
  } else cased(context, palette.hand, 2, () => outlinePath(context, view, object, 4));
  context.restore();
}

/** Half the side of a drawn handle, in px. Its target is larger: see the tools' reach. */
const HANDLE_PX = 6;

/**
 * Draws a handle of a selected thing: a square for its size, a circle for an end or a point, larger ones to turn it and
 * to add a point.
 */
export function drawHandle(context: CanvasRenderingContext2D, frame: MarkFrame, handle: Handle): void {
  const { view, palette } = frame;
  const at = toPx(view, handle.at);
  context.save();
  context.shadowColor = 'rgba(0, 0, 0, 0.3)';
  context.shadowBlur = 4;
  context.shadowOffsetY = 1;
  context.fillStyle = palette.handGround;
  context.beginPath();
  if (handle.kind === 'rotate') context.arc(at.x, at.y, 11, 0, 2 * Math.PI);
  else if (handle.kind === 'add') context.arc(at.x, at.y, 8, 0, 2 * Math.PI);
  else if (handle.kind === 'size')
    context.roundRect(at.x - HANDLE_PX, at.y - HANDLE_PX, 2 * HANDLE_PX, 2 * HANDLE_PX, 3);
  else context.arc(at.x, at.y, HANDLE_PX, 0, 2 * Math.PI);
  context.fill();
  context.shadowColor = 'transparent';
  context.strokeStyle = palette.hand;
  context.lineWidth = 2;
  context.stroke();
  if (handle.kind === 'add') {
    context.beginPath();
    context.moveTo(at.x - 4, at.y);
    context.lineTo(at.x + 4, at.y);
    context.moveTo(at.x, at.y - 4);
    context.lineTo(at.x, at.y + 4);
    context.stroke();
  }
  if (handle.kind === 'rotate') {
    context.translate(at.x, at.y);
    context.scale(0.58, 0.58);
    context.translate(-12, -12);
    context.fillStyle = palette.hand;
    context.fill(rotateIcon());
  }
  context.restore();
}

const rotateIcon = once(() => new Path2D(mdiRotateRight));

/** Draws the crosshair of the keyboard; `isDown`: while it draws. */
export function drawCrosshair(context: CanvasRenderingContext2D, frame: MarkFrame, atMm: Vec, isDown: boolean): void {
  const at = toPx(frame.view, atMm);
  const color = isDown ? frame.palette.hand : frame.palette.pill;
  const [inner, outer] = isDown ? [3, 16] : [6, 20];
  context.save();
  context.lineCap = 'round';
  cased(context, color, 2, () => {
    context.beginPath();
    for (const [x, y] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ] as const) {
      context.moveTo(at.x + x * inner, at.y + y * inner);
      context.lineTo(at.x + x * outer, at.y + y * outer);
    }
  });
  context.restore();
}
