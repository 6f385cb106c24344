import { property, shapeProperties } from '../json-text';
import { sceneDefaults, type Tunnel } from '../scene';
import { shapeBounds, shapeParts } from '../shape/shape';
import { standing, type SceneKind } from './kind';

/** Tunnels: roofs without walls. */
export const tunnel: SceneKind<Tunnel> = {
  name: 'tunnel',
  write: (tunnel, rotation) => [
    ...shapeProperties(tunnel, rotation),
    ...property('round', tunnel.round ?? sceneDefaults.round, sceneDefaults.round),
  ],
  ...standing<Tunnel>(shapeParts),
  solid: () => [],
  bounds: shapeBounds,
};
