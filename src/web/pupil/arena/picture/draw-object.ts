import { degOf } from '#core/angle';
import type { Pose } from '#core/geometry';
import { kindOf } from '#picture/kinds/index';
import { moverOutline, moverShapes } from '#picture/kinds/mover';
import type { Mover, SceneObject } from '#scene/scene';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';
import { drawBody, drawStanding, placedAtStart } from './draw-bodies';
import { drawShapes, lookOf } from './draw-shapes';
import { drawStroke } from './draw-stroke';

/** Draws one object of a course as it is at the start, in CSS px. */
export function drawObject(context: CanvasRenderingContext2D, view: View, object: SceneObject, palette: Palette): void {
  const kind = kindOf(object);
  const look = lookOf(view, palette);
  drawShapes(context, view, kind.ground?.(object, look) ?? []);
  if (object.type === 'stroke') drawStroke(context, view, object, palette);
  drawShapes(context, view, kind.sign?.(object, look) ?? []);
  drawShapes(context, view, kind.mark?.(object, look) ?? []);
  drawStanding(context, view, kind, object, palette);
}

/** Draws a moving obstacle where it is now. */
export function drawMover(
  context: CanvasRenderingContext2D,
  view: View,
  mover: Mover,
  pose: Pose | null,
  palette: Palette,
): void {
  const now = pose ?? placedAtStart(mover).pose;
  const shapes = moverShapes(mover, degOf(now.headingRad), lookOf(view, palette));
  drawBody(context, view, now, moverOutline(mover), shapes);
}
