import { collected, type Contribution } from '../kit/features/feature';

/** What all features bring to the menu and to the help: each has a `contribution.ts`. Loaded on demand. */
export const contributions: readonly Contribution[] = collected(
  import.meta.glob<Contribution>('../**/contribution.ts', { eager: true, import: 'contribution' }),
);
