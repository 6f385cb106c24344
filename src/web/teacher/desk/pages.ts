import type { FeaturePage } from '../../kit/features/feature-page';
import { DESK } from './back-to-desk';

export const pages: readonly FeaturePage[] = [{ name: DESK, load: () => import('./DeskPage.vue') }];
