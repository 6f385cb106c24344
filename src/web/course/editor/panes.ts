import type { FeaturePane } from '../../session/layout/feature-pane';

export const panes: readonly FeaturePane[] = [{ place: 'bench', load: () => import('./ToolBench.vue') }];
