import type { FeaturePage } from '../../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [
  { name: 'robots', hasIds: true, load: () => import('./RobotGallery.vue') },
];
