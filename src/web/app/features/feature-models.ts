import { collected } from '../../kit/features/feature';
import type { JoinModels } from '../../session/models/session';

/** The functions that join the models of all features to the session's: each has a `models.ts`. */
export const featureModels: readonly JoinModels[] = collected(
  import.meta.glob<JoinModels>('../../**/models.ts', { eager: true, import: 'join' }),
);
