import { useLayout } from '../../session/layout/parts';
import type { FeatureWindow } from '../../kit/features/feature-window';
import { useElsewhere } from './parts';

/** The card about work from WebTigerPython. In the frame of another page there is none: that page knows what it opens. */
export const windows: readonly FeatureWindow[] = [
  {
    layer: 'task',
    shows() {
      const { layout } = useLayout();
      const { brought } = useElsewhere();
      return () => window.parent === window && brought.shown.value !== null && layout.parts.value.includes('code');
    },
    load: () => import('./BroughtCard.vue'),
  },
];
