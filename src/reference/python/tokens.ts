/** A piece of Python source. `comment` and `newline` (the end of a statement's line) are pieces too. */
export interface Token {
  readonly kind: 'name' | 'number' | 'string' | 'operator' | 'comment' | 'newline';
  readonly text: string;
  readonly from: number;
  readonly to: number;
  /** A string whose closing quotes are missing. */
  readonly open?: true;
}

const PIECES =
  /(?<space>[ \t\f]+|\\\r?\n)|(?<comment>#[^\n]*)|(?<newline>\r?\n)|(?<string>[rRbBuUfF]{0,2}(?:'''|"""|'|"))|(?<name>[\p{L}_][\p{L}\p{N}_]*)|(?<number>\d[\w.]*(?<=[eE])[+-]\d+|\d[\w.]*|\.\d[\w]*)|(?<operator>->|:=|\*\*=?|\/\/=?|<<=?|>>=?|[!=<>+\-*/%&|^@]=|\S)/uy;

const OPENING = '([{';
const CLOSING = ')]}';
/** Words that begin a statement and nothing else: a line that starts with one of them ends brackets left open. */
const STARTS = new Set([
  'def',
  'class',
  'import',
  'while',
  'return',
  'try',
  'with',
  'global',
  'break',
  'continue',
  'pass',
  'raise',
  'del',
]);

/**
 * Cuts Python source into pieces; never fails. Inside brackets a line's end is no `newline`, unless the next line begins
 * with a word that only a statement begins with: then a closing bracket is missing.
 */
export function tokenize(source: string): Token[] {
  const tokens: Token[] = [];
  let depth = 0;
  let lineStart = true;
  let at = 0;
  while (at < source.length) {
    PIECES.lastIndex = at;
    const groups = PIECES.exec(source)?.groups;
    if (groups === undefined) break;
    const { space, comment, newline, string, name } = groups;
    const text = space ?? comment ?? newline ?? string ?? name ?? groups.number ?? groups.operator ?? '';
    const from = at;
    at += text.length;
    if (space !== undefined) continue;
    if (newline !== undefined) {
      lineStart = true;
      if (depth === 0) tokens.push({ kind: 'newline', text, from, to: at });
      continue;
    }
    if (lineStart && depth > 0 && name !== undefined && STARTS.has(name)) {
      depth = 0;
      tokens.push({ kind: 'newline', text: '', from, to: from });
    }
    lineStart = false;
    if (string !== undefined) {
      const end = endOfString(source, at, string);
      at = end.to;
      tokens.push({ kind: 'string', text: source.slice(from, at), from, to: at, ...(end.open ? { open: true } : {}) });
      continue;
    }
    if (OPENING.includes(text)) depth += 1;
    else if (CLOSING.includes(text)) depth = Math.max(0, depth - 1);
    const kind = kindOf(comment, name, groups.number);
    tokens.push({ kind, text, from, to: at });
  }
  return tokens;
}

function kindOf(comment: string | undefined, name: string | undefined, number: string | undefined): Token['kind'] {
  if (comment !== undefined) return 'comment';
  if (name !== undefined) return 'name';
  return number === undefined ? 'operator' : 'number';
}

function endOfString(source: string, from: number, start: string): { to: number; open: boolean } {
  const quotes = start.replace(/^[a-zA-Z]+/, '');
  let at = from;
  while (at < source.length) {
    if (source[at] === '\\') {
      at += 2;
    } else if (source.startsWith(quotes, at)) {
      return { to: at + quotes.length, open: false };
    } else if (source[at] === '\n' && quotes.length === 1) {
      return { to: at, open: true };
    } else {
      at += 1;
    }
  }
  return { to: Math.min(at, source.length), open: true };
}
