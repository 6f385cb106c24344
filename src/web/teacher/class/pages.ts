import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'class', load: () => import('./ClassPage.vue') }];
