import { collected } from '../../kit/features/feature';
import type { FeatureWindow } from '../../kit/features/feature-window';

/** Everything that features draw over the page: each brings a `windows.ts`. */
export const featureWindows: readonly FeatureWindow[] = collected(
  import.meta.glob<readonly FeatureWindow[]>('../../**/windows.ts', { eager: true, import: 'windows' }),
).flat();
