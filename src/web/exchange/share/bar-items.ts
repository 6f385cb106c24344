import type { Component } from 'vue';

import type { BarItem } from '../../session/layout/bar-item';
import ShareButton from './ShareButton.vue';

export const barItems: readonly BarItem[] = [
  { place: 'share', kinds: ['wide', 'medium', 'narrow'], view: ShareButton as Component },
];
