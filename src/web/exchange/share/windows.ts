import type { Component } from 'vue';

import type { FeatureWindow } from '../../kit/features/feature-window';
import { useTask } from '../../session/task/parts';
import DropArea from './DropArea.vue';

/** The area that takes dropped files listens as long as the page is there; handing in is opened by whoever offers it. */
export const windows: readonly FeatureWindow[] = [
  { layer: 'window', shows: () => () => true, view: DropArea as Component },
  {
    layer: 'window',
    shows() {
      const { task } = useTask();
      return () => task.handIn.isOpen.value;
    },
    load: () => import('./HandInDialog.vue'),
  },
];
