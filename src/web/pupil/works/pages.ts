import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'works', hasIds: true, load: () => import('./WorksPage.vue') }];
