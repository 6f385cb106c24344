import type { FeatureWindow } from '../../kit/features/feature-window';
import { useRun } from '../../session/run/parts';

export const windows: readonly FeatureWindow[] = [
  {
    layer: 'window',
    shows() {
      const { run } = useRun();
      return () => run.recording.value.why.value !== null;
    },
    load: () => import('./WhyCard.vue'),
  },
];
