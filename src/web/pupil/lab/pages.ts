import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'lab', hasIds: true, load: () => import('./LabPage.vue') }];
