import type { FeaturePage } from '../../../kit/features/feature-page';

/** People write the address of a course from memory, too: `#course=slalom`. */
const WRITTEN = /^#courses?[=/]([^/]+)$/;

export const pages: readonly FeaturePage[] = [
  {
    name: 'courses',
    hasIds: true,
    read: (hash) => WRITTEN.exec(hash)?.[1] ?? null,
    load: () => import('./CourseGallery.vue'),
  },
];
