import type { Token } from './tokens';

/** Words that stand before a bracket without calling anything. */
export const WORDS_BEFORE_VALUES: ReadonlySet<string> = new Set([
  ...['and', 'assert', 'await', 'del', 'elif', 'else', 'except', 'for', 'from', 'if', 'import', 'in', 'is', 'lambda'],
  ...['not', 'or', 'raise', 'return', 'while', 'with', 'yield'],
]);

/** Place of the bracket that closes the one at `open`; the last piece when it is missing. */
export function closingOf(tokens: readonly Token[], open: number): number {
  let depth = 0;
  for (let place = open; place < tokens.length; place += 1) {
    const { kind, text } = tokens[place] ?? { kind: 'name', text: '' };
    if (kind !== 'operator') continue;
    if ('([{'.includes(text)) depth += 1;
    else if (')]}'.includes(text)) depth -= 1;
    if (depth === 0) return place;
  }
  return tokens.length - 1;
}

function openingOf(tokens: readonly Token[], close: number): number {
  let depth = 0;
  for (let place = close; place >= 0; place -= 1) {
    const { kind, text } = tokens[place] ?? { kind: 'name', text: '' };
    if (kind !== 'operator') continue;
    if (')]}'.includes(text)) depth += 1;
    else if ('([{'.includes(text)) depth -= 1;
    if (depth === 0) return place;
  }
  return -1;
}

/** The pieces of `a.b(c)[d]` that end at the place `last`; none when no value ends there. */
export function chainEndingAt(tokens: readonly Token[], last: number): readonly Token[] {
  let place = last;
  for (;;) {
    const token = tokens[place];
    if (token === undefined) return [];
    if (token.kind === 'operator') {
      if (!')]}'.includes(token.text)) return [];
      place = openingOf(tokens, place);
      if (place < 0) return [];
      const before = tokens[place - 1];
      if (before !== undefined && continuesIntoBracket(before)) {
        place -= 1;
        continue;
      }
    } else if (WORDS_BEFORE_VALUES.has(token.text)) {
      return [];
    }
    if (tokens[place - 1]?.text !== '.') return tokens.slice(place, last + 1);
    place -= 2;
  }
}

function continuesIntoBracket({ kind, text }: Token): boolean {
  if (kind === 'name') return !WORDS_BEFORE_VALUES.has(text);
  return kind === 'string' || (kind === 'operator' && ')]}'.includes(text));
}

/** A call whose bracket is still open. */
export interface OpenCall {
  /** The pieces of what is called. */
  readonly callee: readonly Token[];
  /** The bracket. */
  readonly bracket: Token;
  /** Which argument the end of the pieces belongs to, from 0. */
  readonly argument: number;
  /** The name before `=` of that argument; `null` for an argument without one. */
  readonly keyword: string | null;
}

/** The innermost call that these pieces of one statement leave open; `null` for none, and for `def f(`. */
export function openCall(tokens: readonly Token[]): OpenCall | null {
  let depth = 0;
  let commas = 0;
  let begin = tokens.length;
  for (let place = tokens.length - 1; place >= 0; place -= 1) {
    const token = tokens[place];
    if (token?.kind !== 'operator') continue;
    if (')]}'.includes(token.text)) depth += 1;
    else if (depth > 0 && '([{'.includes(token.text)) depth -= 1;
    else if (depth === 0 && token.text === ',') {
      if (commas === 0) begin = place + 1;
      commas += 1;
    } else if (depth === 0 && '[{'.includes(token.text)) {
      // Inside a list of a call: what counts is the call around it.
      commas = 0;
      begin = place;
    } else if (depth === 0 && token.text === '(') {
      const before = tokens[place - 2]?.text;
      const callee = before === 'def' || before === 'class' ? [] : chainEndingAt(tokens, place - 1);
      if (callee.length === 0) {
        commas = 0;
        begin = place;
        continue;
      }
      if (commas === 0 && begin === tokens.length) begin = place + 1;
      const keyword = tokens[begin + 1]?.text === '=' ? (tokens[begin]?.text ?? null) : null;
      return { callee, bracket: token, argument: commas, keyword };
    }
  }
  return null;
}
