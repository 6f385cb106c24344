import type { Component } from 'vue';

import type { BarItem } from '../../session/layout/bar-item';
import DeviceMenu from './DeviceMenu.vue';

export const barItems: readonly BarItem[] = [
  { place: 'work', kinds: ['wide', 'medium'], view: DeviceMenu as Component },
];
