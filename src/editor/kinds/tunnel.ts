import type { Tunnel } from '#scene/scene';
import { shapeNames } from '#scene/shape/shape';
import { boxed, boxFields } from './box';
import type { EditorKind } from './kind';
import { bodyShape, shapeField } from './shapes';

/** Tunnels: sized and turned like fields. */
export const tunnel: EditorKind<Tunnel> = {
  layer: 0,
  ...boxed,
  fields: (tunnel) => [
    shapeField(tunnel, shapeNames, (bare, shape) => ({ ...bare, ...bodyShape(shape) })),
    ...boxFields(tunnel),
  ],
  // Chosen: a robot drives through with room on both sides, and is wholly in the dark for a while.
  made: (id, at) => ({ type: 'tunnel', id, at, size: [400, 200], angle: 0 }),
};
