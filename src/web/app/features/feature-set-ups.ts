import { collected } from '../../kit/features/feature';
import type { SetUp } from '../../session/models/session';

/** The features' set-ups: each has a `set-up.ts`. */
export const featureSetUps: readonly SetUp[] = collected(
  import.meta.glob<SetUp>('../../**/set-up.ts', { eager: true, import: 'setUp' }),
);
