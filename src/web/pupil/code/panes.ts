import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import CodePane from './CodePane.vue';
import PeekSlot from './PeekSlot.vue';

export const panes: readonly FeaturePane[] = [
  { place: 'code', view: CodePane as Component, staysMade: true },
  { place: 'arena', slot: 'peek', view: PeekSlot as Component },
];
