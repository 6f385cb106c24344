/** The drawing of fields: zones, and coloured sheets among them. Loaded when a course first has one. */
import { zone } from '#picture/kinds/zone';
import { isField, isZone } from '#scene/kinds/zone';
import type { Scene } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';
import { drawShapes, lookOf } from './draw-shapes';
import type * as Sheets from './sheets';
import { zoneState } from './zone-state';

/** Draws the grounds of fields, under the lines, in CSS px. @param sheets the drawing of sheets, once it has come */
export function drawZones(
  context: CanvasRenderingContext2D,
  view: View,
  { objects }: Pick<Scene, 'objects'>,
  palette: Palette,
  sheets: typeof Sheets | null,
): void {
  const look = lookOf(view, palette);
  for (const object of objects.filter(isField)) {
    const ground = object.type === 'paper' ? sheets?.sheet(object, look) : zone.ground?.(object, look);
    drawShapes(context, view, ground ?? []);
  }
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
