import type { Component } from 'vue';

import type { BarItem } from '../session/layout/bar-item';
import LogoButton from './LogoButton.vue';

export const barItems: readonly BarItem[] = [{ place: 'brand', view: LogoButton as Component }];
