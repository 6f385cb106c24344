import { collected, type Contribution } from '../../kit/features/feature';

/** The contributions of all features to the main menu: each has a `contribution.ts`. Loaded on demand. */
export const contributions: readonly Contribution[] = collected(
  import.meta.glob<Contribution>('../../**/contribution.ts', { eager: true, import: 'contribution' }),
);
