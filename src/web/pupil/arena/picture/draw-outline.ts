import { radOf } from '#core/angle';
import type { Vec } from '#core/geometry';
import { formOf, inset, pairs, polygonPath } from '#picture/form';
import { kindOf } from '#picture/kinds/index';
import type { Outline } from '#scene/outline';
import type { RobotStart, SceneObject, Shaped } from '#scene/scene';
import { linePath } from './draw-shapes';
import { toPx, type View } from '../view/view-transform';

/**
 * Begins a path around an object, in CSS px; of a moving obstacle, where it starts. Of a line it is the line itself, to
 * be stroked wider than the line is.
 *
 * @param growPx distance outside the object
 */
export function outlinePath(context: CanvasRenderingContext2D, view: View, object: SceneObject, growPx: number): void {
  context.beginPath();
  if ('points' in object) {
    object.points.forEach((point, i) => {
      const at = toPx(view, { x: point[0], y: point[1] });
      if (i === 0) context.moveTo(at.x, at.y);
      context.lineTo(at.x, at.y);
    });
    return;
  }
  const frame = kindOf(object).frame(object);
  if (frame === null) return;
  const { at, angleRad, size } = frame;
  const centre = toPx(view, at);
  const width = size.x * view.pxPerMm + 2 * growPx;
  const height = size.y * view.pxPerMm + 2 * growPx;
  context.save();
  context.translate(centre.x, centre.y);
  context.rotate(-angleRad);
  if ('corners' in object) linePath(context, pairs(grown(object, view.pxPerMm, growPx)));
  else if ('round' in object && object.round) context.ellipse(0, 0, width / 2, height / 2, 0, 0, 2 * Math.PI);
  else context.roundRect(-width / 2, -height / 2, width, height, Math.min(3 + growPx, width / 3, height / 3));
  context.restore(); // the path keeps its place
}

/** A polygon about its middle in CSS px, with its edges moved outwards. */
function grown(object: Shaped, pxPerMm: number, growPx: number): Outline {
  const px = polygonPath(formOf(object)).map(({ x, y }) => ({ x: x * pxPerMm, y: y * pxPerMm }));
  return inset(px, -growPx);
}

/** The parts of the robot's outline where it starts, in CSS px. */
export function robotOutlinePx(view: View, start: RobotStart, parts: readonly (readonly Vec[])[]): Vec[][] {
  const rad = radOf(start.heading);
  const [cos, sin] = [Math.cos(rad) * start.scale, Math.sin(rad) * start.scale];
  return parts.map((part) =>
    part.map(({ x, y }) => toPx(view, { x: start.at[0] + x * cos - y * sin, y: start.at[1] + x * sin + y * cos })),
  );
}

/**
 * Draws the outline of a robot dashed, without the lines between its parts.
 *
 * @param ratio canvas pixels per CSS px
 */
export function drawRobotOutline(
  context: CanvasRenderingContext2D,
  partsPx: readonly (readonly Vec[])[],
  ratio: number,
  color: string,
): void {
  const corners = partsPx.flat();
  if (corners.length === 0) return;
  const rim = 4;
  const left = Math.floor(Math.min(...corners.map(({ x }) => x)) - rim);
  const top = Math.floor(Math.min(...corners.map(({ y }) => y)) - rim);
  const width = Math.ceil(Math.max(...corners.map(({ x }) => x)) + rim) - left;
  const height = Math.ceil(Math.max(...corners.map(({ y }) => y)) + rim) - top;
  const canvas = document.createElement('canvas');
  canvas.width = Math.ceil(width * ratio);
  canvas.height = Math.ceil(height * ratio);
  const on = canvas.getContext('2d');
  if (on === null || width > 4000 || height > 4000) return;
  on.setTransform(ratio, 0, 0, ratio, -left * ratio, -top * ratio);
  on.strokeStyle = color;
  on.lineWidth = 4; // its inner half is taken away
  on.setLineDash([6, 5]);
  on.lineJoin = 'round';
  const path = new Path2D();
  for (const part of partsPx) {
    part.forEach(({ x, y }, i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    path.closePath();
  }
  on.stroke(path);
  on.globalCompositeOperation = 'destination-out';
  on.fillStyle = '#000';
  on.fill(path);
  context.drawImage(canvas, left, top, width, height);
}
