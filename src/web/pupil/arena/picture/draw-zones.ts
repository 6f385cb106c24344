/** The drawing of fields: zones and coloured sheets. Loaded when a course first has one. */
import { paper } from '#picture/kinds/paper';
import { zone } from '#picture/kinds/zone';
import { isField, isZone } from '#scene/kinds/zone';
import type { Look } from '#picture/look';
import { paints } from '#picture/paints';
import { group, written, type Shape } from '#picture/shapes';
import type { Paper, Scene, Zone } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import { valueText } from '../../../course/editor/words/value-text';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';
import { drawShapes, lookOf } from './draw-shapes';
import { zoneState } from './zone-state';

/** Draws the grounds of fields, under the lines, in CSS px. */
export function drawZones(
  context: CanvasRenderingContext2D,
  view: View,
  { objects }: Pick<Scene, 'objects'>,
  palette: Palette,
): void {
  const look = lookOf(view, palette);
  for (const object of objects) if (isField(object)) drawShapes(context, view, groundOf(object, look));
}

const groundOf = (field: Zone | Paper, look: Look): readonly Shape[] =>
  field.type === 'paper' ? [...(paper.ground?.(field, look) ?? []), wordOf(field)] : (zone.ground?.(field, look) ?? []);

/** Letters of the word on a sheet: their height in mm, and as a share of the sheet's. Chosen, to be read beside robots. */
const LETTERS_MM = 14;
const LETTERS_SHARE = 0.2;

/** The colour of a sheet as a word, for those who cannot tell colours apart: at its lower edge. */
function wordOf({ at, size, angle, color, round, corners }: Paper): Shape {
  const isPlain = round !== true && corners === undefined;
  const letters = Math.min(LETTERS_MM, LETTERS_SHARE * Math.min(...size));
  const down = isPlain ? size[1] / 2 - 1.2 * letters : 0;
  return group(at, [group([0, down], [written(valueText(color), letters, paints[color].ink)])], angle);
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
