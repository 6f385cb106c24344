import type { BoardApi, Feature } from '#core/board-api';
import type { ReferenceModule } from './types';

/** The board, libraries and files that a program can use. */
export interface ReferenceContext {
  readonly board: BoardApi;
  readonly features: readonly Feature[];
  /** Modules beside the board's own: a robot's libraries. */
  readonly modules: readonly ReferenceModule[];
  /** The other files of the project: file name → source. They win over modules of the same name. */
  readonly files: Readonly<Record<string, string>>;
}
