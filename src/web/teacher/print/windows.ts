import { useCourseEditor } from '../../course/editor/state/parts';
import type { FeatureWindow } from '../../kit/features/feature-window';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'window',
    shows() {
      const { panels } = useCourseEditor();
      return () => panels.shown.value === 'print';
    },
    load: () => import('./EditorPrint.vue'),
  },
];
