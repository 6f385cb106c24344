import type { FeatureWindow } from '../../kit/features/feature-window';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useWork } from '../../session/work/model/parts';
import { useFirstSteps } from '../parts';
import { useGreeting } from './use-greeting';

/** The greeting, on a page with the bar. */
export const windows: readonly FeatureWindow[] = [
  {
    layer: 'help',
    shows() {
      const app = { ...useLayout(), ...useRun(), ...useWork(), ...useFirstSteps() };
      const isGreeted = useGreeting(app);
      return () => isGreeted.value && app.layout.parts.value.includes('bar');
    },
    load: () => import('./WelcomeCard.vue'),
  },
];
