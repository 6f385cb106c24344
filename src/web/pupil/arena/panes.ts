import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import ArenaPane from './ArenaPane.vue';

export const panes: readonly FeaturePane[] = [{ place: 'arena', view: ArenaPane as Component }];
