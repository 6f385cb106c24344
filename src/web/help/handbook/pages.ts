import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'handbook', hasIds: true, load: () => import('./BookPage.vue') }];
