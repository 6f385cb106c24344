import { collected } from '../../kit/features/feature';
import type { FeaturePane } from '../../session/layout/feature-pane';

/** The panes of all features: each brings a `panes.ts`. */
export const featurePanes: readonly FeaturePane[] = collected(
  import.meta.glob<readonly FeaturePane[]>('../../**/panes.ts', { eager: true, import: 'panes' }),
).flat();
