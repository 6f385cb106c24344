import type { Component } from 'vue';

import type { BarItem } from '../session/layout/bar-item';
import HelpButton from './HelpButton.vue';

export const barItems: readonly BarItem[] = [
  { place: 'help', kinds: ['wide', 'medium'], view: HelpButton as Component },
];
