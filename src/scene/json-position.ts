/** The place where a text stops being JSON: line and column count from 1. */
export interface JsonPosition {
  readonly line: number;
  readonly column: number;
}

/**
 * Finds the first place where a text breaks the grammar of JSON (RFC 8259), the same in every engine.
 * Engines word and place the errors of `JSON.parse` differently, some without a place.
 *
 * @returns `null` for a text that is JSON
 */
export function findJsonError(text: string): JsonPosition | null {
  const offset = errorOffset(text);
  if (offset === null) return null;
  let line = 1;
  let lineStart = 0;
  for (let at = text.indexOf('\n'); at >= 0 && at < offset; at = text.indexOf('\n', at + 1)) {
    line++;
    lineStart = at + 1;
  }
  return { line, column: offset - lineStart + 1 };
}

const TOKEN =
  /[ \t\n\r]*(?:([{}[\],:])|("(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*")|(-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?(?![\w.+-])|(?:true|false|null)(?!\w)))/y;

/** The tokens that may come next. */
type Expected = 'value' | 'value-or-end' | 'key' | 'key-or-end' | 'colon' | 'comma-or-end';

/** Walks token by token with an explicit stack: deep nesting costs no recursion. */
function errorOffset(text: string): number | null {
  const open: ('{' | '[')[] = [];
  let expected: Expected = 'value';
  let started = false;
  TOKEN.lastIndex = 0;
  for (;;) {
    const before = TOKEN.lastIndex;
    const start = skipSpace(text, before);
    if (started && open.length === 0) return start === text.length ? null : start;
    const token = TOKEN.exec(text);
    if (!token) return start;
    started = true;
    const next = step(open, expected, token[1] ?? (token[2] === undefined ? 'scalar' : 'string'));
    if (!next) return start;
    expected = next;
  }
}

/** The state after the token; `null` if it may not occur here. Changes the stack of open brackets. */
function step(open: ('{' | '[')[], expected: Expected, token: string): Expected | null {
  if (expected === 'colon') return token === ':' ? 'value' : null;
  const inside = open.at(-1);
  if (expected === 'comma-or-end') {
    if (token === ',') return inside === '{' ? 'key' : 'value';
    return close(open, token);
  }
  if (expected === 'key' || expected === 'key-or-end') {
    if (token === 'string') return 'colon';
    return expected === 'key-or-end' ? close(open, token) : null;
  }
  if (token === '{' || token === '[') {
    open.push(token);
    return token === '{' ? 'key-or-end' : 'value-or-end';
  }
  if (token === 'string' || token === 'scalar') return 'comma-or-end';
  return expected === 'value-or-end' ? close(open, token) : null;
}

function close(open: ('{' | '[')[], token: string): Expected | null {
  if (token !== (open.at(-1) === '{' ? '}' : ']')) return null;
  open.pop();
  return 'comma-or-end';
}

function skipSpace(text: string, from: number): number {
  let at = from;
  while (at < text.length && ' \t\n\r'.includes(text.charAt(at))) at++;
  return at;
}
