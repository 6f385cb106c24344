import type { ErrorCode } from './types';

/** Why a command was not carried out. */
export class ParcoursError extends Error {
  override readonly name = 'ParcoursError';

  /** @param path place of the mistake in the message; empty for none */
  constructor(
    readonly code: ErrorCode,
    message: string,
    readonly path = '',
  ) {
    super(message);
  }
}
