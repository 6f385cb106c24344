import type { Scene, Stroke, Wall } from '#scene/scene';
import { drawFixedBlock, placedBlock } from './draw-blocks';
import { drawFloor, drawRim, floorPx } from './draw-floor';
import { drawRulers } from './draw-rulers';
import { drawWalls } from './draw-walls';
import type { Palette } from './palette';
import { toPx, type CanvasSize, type View } from './view-transform';

/**
 * Draws all of a course that does not move: floor, grid, strokes, walls, fixed blocks, rulers. Drawn again only when
 * the course, the view or the theme changes.
 *
 * @param context draws in CSS px
 */
export function drawScene(
  context: CanvasRenderingContext2D,
  view: View,
  scene: Scene,
  canvas: CanvasSize,
  palette: Palette,
): void {
  drawFloor(context, view, scene.size, canvas, palette);
  const floor = floorPx(view, scene.size);
  context.save();
  context.beginPath();
  context.rect(floor.left, floor.top, floor.width, floor.height);
  context.clip();
  for (const object of scene.objects) if (object.type === 'stroke') drawStroke(context, view, object, palette);
  drawWalls(
    context,
    view,
    scene.objects.filter((object): object is Wall => object.type === 'wall'),
    palette,
  );
  for (const object of scene.objects)
    if (object.type === 'fixed-block') drawFixedBlock(context, view, placedBlock(object), palette);
  context.restore();
  drawRim(context, view, scene.size, palette);
  drawRulers(context, view, scene.size, canvas, palette);
}

function drawStroke(context: CanvasRenderingContext2D, view: View, stroke: Stroke, palette: Palette): void {
  const width = stroke.width * view.pxPerMm;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  context.beginPath();
  stroke.points.forEach((point, i) => {
    const at = toPx(view, { x: point[0], y: point[1] });
    if (i === 0) context.moveTo(at.x, at.y);
    context.lineTo(at.x, at.y);
  });
  if (stroke.color === 'white') {
    context.strokeStyle = palette.strokeEdge;
    context.lineWidth = width + 1.5;
    context.stroke();
  }
  context.strokeStyle = palette.strokes[stroke.color];
  context.lineWidth = width;
  context.stroke();
  context.lineCap = 'butt';
}
