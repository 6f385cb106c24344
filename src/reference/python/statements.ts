import { tokenize, type Token } from './tokens';

/** A statement: its pieces without comments, and how far its line is indented (tabs count to the next four). */
export interface Statement {
  readonly indent: number;
  readonly tokens: readonly Token[];
}

const COMPOUND = new Set(['if', 'elif', 'else', 'for', 'while', 'try', 'except', 'finally', 'with', 'def', 'class']);

/** Cuts a source into statements; `if x: y = 1` is two, the second one indented more. */
export function statementsOf(source: string): Statement[] {
  const statements: Statement[] = [];
  let line: Token[] = [];
  const close = (): void => {
    if (line.length > 0) statements.push(...statementsOfLine(source, line));
    line = [];
  };
  for (const token of tokenize(source)) {
    if (token.kind === 'newline') close();
    else if (token.kind !== 'comment') line.push(token);
  }
  close();
  return statements;
}

/** How far the line at this place is indented. */
export function indentAt(source: string, offset: number): number {
  const start = source.lastIndexOf('\n', offset - 1) + 1;
  let indent = 0;
  for (let at = start; source[at] === ' ' || source[at] === '\t'; at += 1) {
    indent = source[at] === '\t' ? indent - (indent % 4) + 4 : indent + 1;
  }
  return indent;
}

function statementsOfLine(source: string, line: readonly Token[]): Statement[] {
  const [first] = line;
  if (first === undefined) return [];
  const indent = indentAt(source, first.from);
  const statements: Statement[] = [];
  let rest = line;
  let deeper = 0;
  const colon = COMPOUND.has(first.text) ? topLevel(line, ':') : -1;
  if (colon >= 0 && colon < line.length - 1) {
    statements.push({ indent, tokens: line.slice(0, colon + 1) });
    rest = line.slice(colon + 1);
    deeper = 1;
  }
  for (;;) {
    const end = topLevel(rest, ';');
    const tokens = end < 0 ? rest : rest.slice(0, end);
    if (tokens.length > 0) statements.push({ indent: indent + deeper, tokens });
    if (end < 0) return statements;
    rest = rest.slice(end + 1);
  }
}

/** Place of the first of these operators or words outside of brackets (and of `lambda …:`); −1 for none. */
export function topLevel(tokens: readonly Token[], ...wanted: readonly string[]): number {
  let depth = 0;
  let lambdas = 0;
  for (const [place, token] of tokens.entries()) {
    if (token.kind !== 'operator' && token.kind !== 'name') continue;
    if (depth === 0 && token.text === ':' && lambdas > 0) lambdas -= 1;
    else if (depth === 0 && wanted.includes(token.text)) return place;
    if (token.text === 'lambda') lambdas += 1;
    else if ('([{'.includes(token.text)) depth += 1;
    else if (')]}'.includes(token.text)) depth -= 1;
  }
  return -1;
}

/** Cuts at the commas outside of brackets. */
export function splitAtCommas(tokens: readonly Token[]): (readonly Token[])[] {
  const parts: (readonly Token[])[] = [];
  let rest = tokens;
  for (;;) {
    const comma = topLevel(rest, ',');
    if (comma < 0) return rest.length > 0 ? [...parts, rest] : parts;
    parts.push(rest.slice(0, comma));
    rest = rest.slice(comma + 1);
  }
}
