import type { FeaturePane } from '../../session/layout/feature-pane';

/** The output of a board at the cable, which is fetched once there is one. */
export const panes: readonly FeaturePane[] = [
  { place: 'console', slot: 'board', load: () => import('./output/BoardOutput.vue') },
];
