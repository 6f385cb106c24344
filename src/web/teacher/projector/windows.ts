import type { FeatureWindow } from '../../kit/features/feature-window';
import { useLayout } from '../../session/layout/parts';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'window',
    shows() {
      const { alone } = useLayout();
      return () => alone.hasSide.value;
    },
    load: () => import('./ProjectorView.vue'),
  },
];
