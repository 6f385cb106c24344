import type { ErrorCode } from './types';

/** Why a command was not done. */
export class ParcoursError extends Error {
  override readonly name = 'ParcoursError';

  /** @param path place in the message that the page complains about; empty: none */
  constructor(
    readonly code: ErrorCode,
    message: string,
    readonly path = '',
  ) {
    super(message);
  }
}
