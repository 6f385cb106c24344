import { rotationRad } from '#core/angle';
import { START_SIDE_MM } from '#scene/kinds/start';
import type { Block, Label, Mover, SceneObject, Start, Wall, Zone } from '#scene/scene';
import type { View } from '../../view/view-transform';
import type { Palette } from '../../model/palette';
import { drawFixedBlock, drawMovableBlock, placedBlock } from './block';
import { boxFrame, type Frame, type PictureKind } from './kind';
import { drawLabel, labelSize } from './label';
import { drawMover, drawTrack } from './mover';
import { drawSpikes } from './spikes';
import { drawStart } from './start';
import { drawStroke } from './stroke';
import { drawWalls } from './wall';
import { drawZoneGround, drawZoneSign, zoneState } from './zone';

const zone: PictureKind<Zone> = {
  ground: drawZoneGround,
  sign: (context, view, zone, palette, { objects, verdict }) =>
    drawZoneSign(context, view, zone, zoneState(zone, objects, verdict), palette),
  frame: boxFrame,
};

/** Every kind of object by its type. */
export const pictureKinds: Readonly<Record<SceneObject['type'], PictureKind>> = {
  wall: { body: (context, view, wall: Wall, palette) => drawWalls(context, view, [wall], palette), frame: wallFrame },
  block: {
    body: (context, view, block: Block, palette) => drawMovableBlock(context, view, placedBlock(block), false, palette),
    frame: boxFrame,
  },
  'fixed-block': {
    body: (context, view, block: Block, palette) => drawFixedBlock(context, view, placedBlock(block), palette),
    frame: boxFrame,
  },
  stroke: { body: drawStroke, frame: () => null },
  target: zone,
  checkpoint: zone,
  forbidden: zone,
  spikes: { standing: drawSpikes, frame: boxFrame },
  mover: {
    mark: drawTrack,
    body: (context, view, mover: Mover, palette) => drawMover(context, view, mover, null, palette),
    frame: boxFrame,
  },
  label: {
    mark: drawLabel,
    frame: (label: Label) => ({
      at: { x: label.at[0], y: label.at[1] },
      angleRad: rotationRad(label.angle),
      size: labelSize(label),
    }),
  },
  start: {
    mark: drawStart,
    frame: ({ at: [x, y], heading }: Start) => ({
      at: { x, y },
      angleRad: (heading * Math.PI) / 180,
      size: { x: START_SIDE_MM, y: START_SIDE_MM },
    }),
  },
};

/** The kind of an object. */
export const kindOf = ({ type }: SceneObject): PictureKind => pictureKinds[type];

/** Draws one object of a course as it is at the start, in CSS px. */
export function drawObject(context: CanvasRenderingContext2D, view: View, object: SceneObject, palette: Palette): void {
  const kind = kindOf(object);
  kind.ground?.(context, view, object, palette);
  kind.sign?.(context, view, object, palette, { objects: [], verdict: null });
  kind.mark?.(context, view, object, palette);
  kind.standing?.(context, view, object, palette);
  kind.body?.(context, view, object, palette);
}

function wallFrame({ from, to, thickness }: Wall): Frame {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  return {
    at: { x: (from[0] + to[0]) / 2, y: (from[1] + to[1]) / 2 },
    angleRad: Math.atan2(dy, dx),
    size: { x: Math.hypot(dx, dy), y: thickness },
  };
}
