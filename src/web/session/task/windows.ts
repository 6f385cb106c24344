import type { Component } from 'vue';

import type { FeatureWindow } from '../../kit/features/feature-window';
import { useLayout } from '../layout/parts';
import TaskSlot from './TaskSlot.vue';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'task',
    shows() {
      const { layout } = useLayout();
      return () => layout.parts.value.includes('arena');
    },
    view: TaskSlot as Component,
  },
];
