import type { Component } from 'vue';

import type { FeaturePane } from '../layout/feature-pane';
import TaskSlot from './TaskSlot.vue';

/** The card of the task beside the program; above the course where nothing else is on the screen. */
export const panes: readonly FeaturePane[] = [
  { place: 'card', view: TaskSlot as Component },
  { place: 'arena', slot: 'card', view: TaskSlot as Component },
];
