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
}

// Not in the class: TypeScript would declare it twice in the types of the packages.
Object.defineProperty(ParcoursError, Symbol.hasInstance, {
  value: (it: unknown) => it instanceof Error && it.name === 'ParcoursError',
});
