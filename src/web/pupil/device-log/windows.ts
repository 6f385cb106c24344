import type { FeatureWindow } from '../../kit/features/feature-window';
import { useRun } from '../../session/run/parts';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'window',
    shows() {
      const { dataLog } = useRun();
      return () => dataLog.isCompared.value;
    },
    load: () => import('./DeviceLogWindow.vue'),
  },
];
