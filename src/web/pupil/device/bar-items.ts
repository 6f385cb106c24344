import type { Component } from 'vue';

import type { BarItem } from '../../session/layout/bar-item';
import DeviceMenu from './DeviceMenu.vue';

export const barItems: readonly BarItem[] = [
  { place: 'work', order: 20, kinds: ['wide', 'medium', 'narrow'], view: DeviceMenu as Component },
];
