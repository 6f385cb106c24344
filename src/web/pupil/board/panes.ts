import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import BoardPane from './BoardPane.vue';

export const panes: readonly FeaturePane[] = [{ place: 'board', view: BoardPane as Component }];
