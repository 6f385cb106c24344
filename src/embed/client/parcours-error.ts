import type { ErrorCode } from './types';

/**
 * Why a command was not carried out. Every package brings this class along; `instanceof` takes an error of any of them.
 */
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

  static override [Symbol.hasInstance](value: unknown): boolean {
    return value instanceof Error && value.name === 'ParcoursError';
  }
}
