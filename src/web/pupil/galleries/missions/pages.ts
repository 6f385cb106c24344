import type { FeaturePage } from '../../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [
  { name: 'missions', hasIds: true, load: () => import('./MissionGallery.vue') },
];
