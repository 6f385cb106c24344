import type { ReferenceContext } from './context';
import { Reader } from './python/reader';
import { tokenize, type Token } from './python/tokens';

/** A place in a program: what stands around it. */
export interface Place {
  readonly reader: Reader;
  /** The piece that the place is in or at the end of: a name, string, number or comment. */
  readonly inside: Token | null;
  /** The pieces of its statement before `inside`. */
  readonly before: readonly Token[];
  /** The piece after `inside`. */
  readonly next: Token | null;
}

/** Reads a program up to a place in it. Never fails, whatever the program looks like. */
export function placeAt(source: string, offset: number, context: ReferenceContext): Place {
  const tokens = tokenize(source);
  const index = tokens.findIndex((token) => isInside(token, offset));
  const inside = tokens[index] ?? null;
  const until = inside === null ? tokens.findIndex((token) => token.from >= offset) : index;
  const earlier = until < 0 ? tokens : tokens.slice(0, until);
  const lineEnd = earlier.findLastIndex((token) => token.kind === 'newline' || token.text === ';');
  const before = earlier.slice(lineEnd + 1).filter((token) => token.kind !== 'comment');
  const next = (inside === null ? tokens[until] : tokens[index + 1]) ?? null;
  return { reader: new Reader(source, context), inside, before, next };
}

function isInside({ kind, from, to, open }: Token, offset: number): boolean {
  switch (kind) {
    case 'name':
    case 'number':
    case 'comment':
      return from < offset && offset <= to;
    case 'string':
      return from < offset && (offset < to || (open === true && offset === to));
    case 'operator':
    case 'newline':
      return false;
  }
}
