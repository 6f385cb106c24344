import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import ConsolePane from './ConsolePane.vue';
import { useConsole } from './parts';

export const panes: readonly FeaturePane[] = [
  { place: 'console', view: ConsolePane as Component, staysMade: true, news: () => useConsole().console.isNew },
];
