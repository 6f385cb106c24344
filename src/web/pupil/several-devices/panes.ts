import type { Component } from 'vue';

import type { FeaturePane } from '../../session/layout/feature-pane';
import DeviceRowSlot from './DeviceRowSlot.vue';

export const panes: readonly FeaturePane[] = [{ place: 'row', view: DeviceRowSlot as Component }];
