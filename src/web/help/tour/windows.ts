import { onMounted, shallowRef } from 'vue';

import type { FeatureWindow } from '../../kit/features/feature-window';
import { whenIdle } from '../../kit/when-idle';
import { useLayout } from '../../session/layout/parts';
import { useFirstSteps } from '../parts';

/** Time until the help is loaded, after the page itself, in ms; a request loads it at once. */
const AFTER_MS = 3000; // chosen: what a first run needs has come by then

/** The tour and the help, on a page with the bar. */
export const windows: readonly FeatureWindow[] = [
  {
    layer: 'help',
    shows() {
      const { layout } = useLayout();
      const { guide, tour } = useFirstSteps();
      const isLate = shallowRef(false);
      onMounted(() => whenIdle(() => void setTimeout(() => (isLate.value = true), AFTER_MS)));
      const isWanted = (): boolean => isLate.value || guide.at.value !== null || tour.isOpen.value;
      return () => isWanted() && layout.parts.value.includes('bar');
    },
    load: () => import('./FirstSteps.vue'),
  },
];
