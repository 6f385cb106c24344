import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import WelcomeSlot from './WelcomeSlot.vue';

/** The question of a first visit, in the place of the task's card. */
export const panes: readonly FeaturePane[] = [
  { place: 'card', view: WelcomeSlot as Component },
  { place: 'arena', slot: 'greeting', view: WelcomeSlot as Component },
];
