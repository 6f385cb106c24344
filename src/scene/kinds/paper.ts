import { paintProperties, property, shapeProperties } from '../json-text';
import { boundsMeet, boundsOfOutline, overlapMm } from '../outline';
import { sceneDefaults, type Paper } from '../scene';
import { shapeBounds, shapeParts } from '../shape/shape';
import type { SceneKind } from './kind';

/** Coloured sheets. */
export const paper: SceneKind<Paper> = {
  name: 'paper',
  write: (paper, rotation) => [
    ...shapeProperties(paper, rotation),
    ...property('round', paper.round ?? sceneDefaults.round, sceneDefaults.round),
    ...paintProperties(paper, sceneDefaults.paper),
  ],
  solid: () => [],
  bounds: shapeBounds,
  reachesInto: (paper, arena) =>
    boundsMeet(shapeBounds(paper), boundsOfOutline(arena)) &&
    shapeParts(paper).some((part) => overlapMm(part, arena) > 0),
};
