import type { FeaturePage } from '../../kit/features/feature-page';

/** The own tasks (`#tasks`), or the shelf of a school at an address (`#shelf=…`), which is then the id. */
const SHELF = /^#(?:tasks\/)?(shelf=.+)$/;

export const pages: readonly FeaturePage[] = [
  { name: 'tasks', hasIds: true, read: (hash) => SHELF.exec(hash)?.[1] ?? null, load: () => import('./TasksPage.vue') },
];
