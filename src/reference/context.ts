import type { BoardApi, Feature } from '#core/board-api';
import type { ReferenceModule } from './types';

/** What a program is written for. */
export interface ReferenceContext {
  readonly board: BoardApi;
  readonly features: readonly Feature[];
  /** Modules beside the board's own: a robot's libraries. */
  readonly modules: readonly ReferenceModule[];
  /** The other files of the project: file name → source. Their modules win over all others. */
  readonly files: Readonly<Record<string, string>>;
}
