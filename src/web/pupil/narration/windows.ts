import type { FeatureWindow } from '../../kit/features/feature-window';
import { useWork } from '../../session/work/model/parts';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'words',
    shows() {
      const { settings } = useWork();
      return () => settings.current.value.tell;
    },
    load: () => import('./NarrationRegion.vue'),
  },
];
