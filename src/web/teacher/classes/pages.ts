import type { FeaturePage } from '../../kit/features/feature-page';
import { CLASSES } from './address';

export const pages: readonly FeaturePage[] = [{ name: CLASSES, load: () => import('./ClassesPage.vue') }];
