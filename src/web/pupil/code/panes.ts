import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import CodePane from './CodePane.vue';
import ProgramPeek from './ProgramPeek.vue';

export const panes: readonly FeaturePane[] = [
  { place: 'code', view: CodePane as Component, staysMade: true },
  { place: 'arena', slot: 'peek', view: ProgramPeek as Component },
];
