import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'my-robot', load: () => import('./MyRobotPage.vue') }];
