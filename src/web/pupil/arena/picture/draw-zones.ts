/** The drawing of zones. Loaded when a course first has one. */
import { zone } from '#picture/kinds/zone';
import { isZone } from '#scene/kinds/zone';
import type { Scene } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';
import { drawShapes, lookOf } from './draw-shapes';
import { zoneState } from './zone-state';

/** Draws the grounds of zones, under the lines, in CSS px. */
export function drawZones(
  context: CanvasRenderingContext2D,
  view: View,
  { objects }: Pick<Scene, 'objects'>,
  palette: Palette,
): void {
  const look = lookOf(view, palette);
  for (const object of objects) if (isZone(object)) drawShapes(context, view, zone.ground?.(object, look) ?? []);
}

/** Draws the numbers and signs of zones, over the lines, in CSS px. */
export function drawZoneSigns(
  context: CanvasRenderingContext2D,
  view: View,
  { objects }: Pick<Scene, 'objects'>,
  verdict: Verdict | null,
  palette: Palette,
): void {
  const look = lookOf(view, palette);
  for (const object of objects) {
    if (!isZone(object)) continue;
    const isReached = zoneState(object, objects, verdict) === 'reached';
    drawShapes(context, view, zone.sign?.(object, look, isReached) ?? []);
  }
}
