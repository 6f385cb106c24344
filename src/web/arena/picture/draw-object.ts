import type { SceneObject } from '#scene/scene';
import { drawFixedBlock, drawMovableBlock, placedBlock } from './draw-blocks';
import { drawLabel } from './draw-label';
import { drawMover, drawSpikes, drawTrack } from './draw-obstacles';
import { drawStroke } from './draw-stroke';
import { drawWalls } from './draw-walls';
import { drawZoneGround, drawZoneSign } from './draw-zones';
import type { Palette } from './palette';
import type { View } from '../view/view-transform';

/** Draws one object of a course as it is at the start, in CSS px. */
export function drawObject(context: CanvasRenderingContext2D, view: View, object: SceneObject, palette: Palette): void {
  switch (object.type) {
    case 'stroke':
      return drawStroke(context, view, object, palette);
    case 'wall':
      return drawWalls(context, view, [object], palette);
    case 'block':
      return drawMovableBlock(context, view, placedBlock(object), false, palette);
    case 'fixed-block':
      return drawFixedBlock(context, view, placedBlock(object), palette);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      drawZoneGround(context, view, object, palette);
      return drawZoneSign(context, view, object, 'open', palette);
    case 'spikes':
      return drawSpikes(context, view, object, palette);
    case 'mover':
      drawTrack(context, view, object, palette);
      return drawMover(context, view, object, null, palette);
    case 'label':
      return drawLabel(context, view, object, palette);
    default:
      return object satisfies never;
  }
}
