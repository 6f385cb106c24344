import type { Component } from 'vue';

import type { BarItem } from '../../session/layout/bar-item';
import RunControls from './RunControls.vue';
import SpeedMenu from './SpeedMenu.vue';

export const barItems: readonly BarItem[] = [
  { place: 'run', view: RunControls as Component },
  { place: 'speed', kinds: ['wide', 'medium', 'narrow'], view: SpeedMenu as Component },
];
