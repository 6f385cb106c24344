import { property, shapeProperties } from '../json-text';
import { boundsMeet, boundsOfOutline, overlapMm } from '../outline';
import { sceneDefaults, type Tunnel } from '../scene';
import { shapeBounds, shapeParts } from '../shape/shape';
import type { SceneKind } from './kind';

/** Tunnels: roofs without walls. */
export const tunnel: SceneKind<Tunnel> = {
  name: 'tunnel',
  write: (tunnel, rotation) => [
    ...shapeProperties(tunnel, rotation),
    ...property('round', tunnel.round ?? sceneDefaults.round, sceneDefaults.round),
  ],
  solid: () => [],
  bounds: shapeBounds,
  reachesInto: (tunnel, arena) =>
    boundsMeet(shapeBounds(tunnel), boundsOfOutline(arena)) &&
    shapeParts(tunnel).some((part) => overlapMm(part, arena) > 0),
};
