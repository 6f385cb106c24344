import type { FeaturePage } from '../../kit/features/feature-page';

/** A series in the link itself (`#s=…`), at an address (`#series=…`), or of this browser (`#series/…`): the id is all of it. */
const SERIES = /^#(s(?:eries[=/]|=).+)$/;

export const pages: readonly FeaturePage[] = [
  { name: 'series', read: (hash) => SERIES.exec(hash)?.[1] ?? null, load: () => import('./SeriesPage.vue') },
  { name: 'make-series', load: () => import('./MakeSeriesPage.vue') },
];
