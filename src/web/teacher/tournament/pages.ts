import type { FeaturePage } from '../../kit/features/feature-page';

export const pages: readonly FeaturePage[] = [{ name: 'tournament', load: () => import('./TournamentPage.vue') }];
