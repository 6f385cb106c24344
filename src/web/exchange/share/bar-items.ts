import type { Component } from 'vue';

import type { BarItem } from '../../session/layout/bar-item';
import ShareButtons from './ShareButtons.vue';

export const barItems: readonly BarItem[] = [{ place: 'files', kinds: ['wide'], view: ShareButtons as Component }];
