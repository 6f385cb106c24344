import type { FeatureWindow } from '../kit/features/feature-window';
import { useLayout } from '../session/layout/parts';

/** The open page over the whole app. */
export const windows: readonly FeatureWindow[] = [
  {
    layer: 'page',
    shows() {
      const { router } = useLayout();
      return () => router.page.value !== null;
    },
    load: () => import('./features/FeaturePages.vue'),
  },
];
