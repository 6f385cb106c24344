import { collected } from '../../kit/features/feature';
import type { FeaturePage } from '../../kit/features/feature-page';

/** The pages of all features: each brings a `pages.ts`. */
export const featurePages: readonly FeaturePage[] = collected(
  import.meta.glob<readonly FeaturePage[]>('../../**/pages.ts', { eager: true, import: 'pages' }),
).flat();
