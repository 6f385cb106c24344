import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'task', load: () => import('./MakerPage.vue') }];
