import type { Component } from 'vue';

import type { FeatureWindow } from '../../kit/features/feature-window';
import LiveRegion from './LiveRegion.vue';

/** Screen readers only hear changes of what is there from the start. */
export const windows: readonly FeatureWindow[] = [
  { layer: 'words', shows: () => () => true, view: LiveRegion as Component },
];
