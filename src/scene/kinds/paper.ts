import { paintProperties, property, shapeProperties } from '../json-text';
import { sceneDefaults, type Paper } from '../scene';
import { shapeBounds, shapeParts } from '../shape/shape';
import { standing, type SceneKind } from './kind';

/** Coloured sheets. */
export const paper: SceneKind<Paper> = {
  name: 'paper',
  write: (paper, rotation) => [
    ...shapeProperties(paper, rotation),
    ...property('round', paper.round ?? sceneDefaults.round, sceneDefaults.round),
    ...paintProperties(paper, sceneDefaults.paper),
  ],
  ...standing<Paper>(shapeParts),
  solid: () => [],
  bounds: shapeBounds,
};
