import type { FeaturePane } from '../../session/layout/feature-pane';

/** The curves of a run, which are fetched once somebody opens their tab of the console. */
export const panes: readonly FeaturePane[] = [
  { place: 'console', slot: 'chart', load: () => import('./ChartPane.vue') },
];
