import type { Component } from 'vue';

import type { FeatureWindow } from '../../kit/features/feature-window';
import DropArea from './DropArea.vue';

/** It listens as long as the page is there. */
export const windows: readonly FeatureWindow[] = [
  { layer: 'window', shows: () => () => true, view: DropArea as Component },
];
