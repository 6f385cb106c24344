import { indentAt, splitAtCommas, statementsOf, topLevel, type Statement } from './statements';
import type { Token } from './tokens';

/** How a name came into a scope. */
export type Binding =
  | { readonly kind: 'import'; readonly module: string }
  | { readonly kind: 'from'; readonly module: string; readonly name: string }
  | { readonly kind: 'function' | 'class'; readonly scope: Scope }
  | { readonly kind: 'parameter'; readonly annotation: readonly Token[] }
  /** The value of an expression; `element`: what `for` takes out of it, `error`: what `except` caught. */
  | { readonly kind: 'value'; readonly of: 'itself' | 'element' | 'error'; readonly tokens: readonly Token[] };

/** A name with its place. */
export interface Bound {
  readonly name: string;
  readonly at: number;
  readonly binding: Binding;
}

/** A part of the source with names of its own. */
export interface Scope {
  readonly kind: 'module' | 'function' | 'class';
  readonly name: string;
  /** `(a, b=1)` of a function, as written; what a class descends from. */
  readonly header: string;
  readonly bases: readonly (readonly Token[])[];
  readonly indent: number;
  readonly from: number;
  /** Where the first statement after it begins. */
  to: number;
  readonly parent: Scope | null;
  readonly names: Bound[];
  /** Names of instances: what methods assign to `self.x`. */
  readonly fields: Bound[];
  /** Names that a function takes from the module by `global`. */
  readonly globals: Set<string>;
  /** Modules imported by `from … import *`. */
  readonly stars: { readonly module: string; readonly at: number }[];
  /** The text in quotes at its beginning. */
  doc: string | null;
}

/** Finds out which names a source has and where they come from. Never fails: what it does not understand is left out. */
export function survey(source: string): Scope {
  const root = scopeOf('module', '', -1, 0, null, source.length);
  let current = root;
  let fresh = true;
  for (const statement of statementsOf(source)) {
    const from = statement.tokens[0]?.from ?? 0;
    while (current.parent !== null && statement.indent <= current.indent) {
      current.to = from;
      current = current.parent;
      fresh = false;
    }
    if (fresh) current.doc = docOf(statement);
    fresh = false;
    const opened = openScope(source, statement, current);
    if (opened === null) {
      bind(statement.tokens, current);
    } else {
      current = opened;
      fresh = true;
    }
  }
  return root;
}

/** The innermost scope at a place: a line that is not indented more than `def` is outside of it. */
export function scopeAt(root: Scope, source: string, offset: number): Scope {
  const indent = indentAt(source, offset);
  const lineStart = source.lastIndexOf('\n', offset - 1) + 1;
  let scope = root;
  for (;;) {
    const inner = innerScopes(scope).find(
      (it) => it.from <= offset && offset <= it.to && (it.from >= lineStart || indent > it.indent),
    );
    if (inner === undefined) return scope;
    scope = inner;
  }
}

function innerScopes(scope: Scope): Scope[] {
  return scope.names.flatMap(({ binding }) =>
    binding.kind === 'function' || binding.kind === 'class' ? [binding.scope] : [],
  );
}

function scopeOf(
  kind: Scope['kind'],
  name: string,
  indent: number,
  from: number,
  parent: Scope | null,
  to: number,
  header = '',
  bases: readonly (readonly Token[])[] = [],
): Scope {
  return {
    kind,
    name,
    header,
    bases,
    indent,
    from,
    to,
    parent,
    names: [],
    fields: [],
    globals: new Set(),
    stars: [],
    doc: null,
  };
}

/** `def` and `class` open a scope. */
function openScope(source: string, { indent, tokens }: Statement, parent: Scope): Scope | null {
  const [first, name, bracket] = tokens;
  if (first === undefined || name?.kind !== 'name' || !(first.text === 'def' || first.text === 'class')) return null;
  const kind = first.text === 'def' ? 'function' : 'class';
  const end = topLevel(tokens, ':', '->');
  const head = bracket?.text === '(' ? tokens.slice(3, end < 0 ? undefined : end) : [];
  const inside = head.at(-1)?.text === ')' ? head.slice(0, -1) : head;
  const last = inside.at(-1);
  const text = inside[0] !== undefined && last !== undefined ? source.slice(inside[0].from, last.to) : '';
  const parts = splitAtCommas(inside);
  const header = `(${text.replace(/\s+/g, ' ')})`;
  const bases = kind === 'class' ? parts : [];
  const scope = scopeOf(kind, name.text, indent, first.from, parent, source.length, header, bases);
  parent.names.push({ name: name.text, at: name.from, binding: { kind, scope } });
  if (kind === 'function') for (const part of parts) bindParameter(part, scope);
  return scope;
}

function bindParameter(part: readonly Token[], scope: Scope): void {
  const place = part.findIndex((token) => token.kind === 'name');
  const token = part[place];
  if (token === undefined) return;
  const equals = topLevel(part, '=');
  const annotated = part[place + 1]?.text === ':';
  const annotation = annotated ? part.slice(place + 2, equals < 0 ? undefined : equals) : [];
  const given = equals < 0 ? [] : part.slice(equals + 1);
  const binding: Binding =
    annotation.length > 0 || given.length === 0 || given[0]?.text === 'None'
      ? { kind: 'parameter', annotation }
      : { kind: 'value', of: 'itself', tokens: given };
  scope.names.push({ name: token.text, at: token.from, binding });
}

function bind(tokens: readonly Token[], scope: Scope): void {
  switch (tokens[0]?.text) {
    case 'import':
      return bindImport(tokens.slice(1), scope);
    case 'from':
      return bindFrom(tokens, scope);
    case 'for':
      return bindFor(tokens, scope);
    case 'global':
      for (const token of tokens.slice(1)) if (token.kind === 'name') scope.globals.add(token.text);
      return;
    case 'with':
      for (const part of splitAtCommas(tokens.slice(1))) bindAs(part, 'itself', scope);
      return;
    case 'except':
      return bindAs(tokens.slice(1), 'error', scope);
    default:
      bindAssignment(tokens, scope);
  }
}

/** Adds a name to its scope: to the module when the function said `global`. */
function declare(scope: Scope, { text, from }: Token, binding: Binding): void {
  let home = scope;
  while (scope.globals.has(text) && home.parent !== null) home = home.parent;
  home.names.push({ name: text, at: from, binding });
}

function bindImport(tokens: readonly Token[], scope: Scope): void {
  for (const part of splitAtCommas(tokens)) {
    const [module, dot] = part;
    if (module?.kind !== 'name') continue;
    const as = part.findIndex((token) => token.text === 'as');
    const name = as < 0 ? module : part[as + 1];
    if (name?.kind !== 'name') continue;
    // `import a.b` binds a; what lies behind the dot is found through it.
    const path = as >= 0 && dot?.text === '.' ? part.slice(0, as).map((token) => token.text) : [module.text];
    declare(scope, name, { kind: 'import', module: path.join('') });
  }
}

function bindFrom(tokens: readonly Token[], scope: Scope): void {
  const place = tokens.findIndex((token) => token.text === 'import');
  if (place < 0) return;
  const module = tokens
    .slice(1, place)
    .map((token) => token.text)
    .join('');
  const names = tokens.slice(place + 1).filter((token) => token.text !== '(' && token.text !== ')');
  for (const part of splitAtCommas(names)) {
    const [first] = part;
    if (first?.text === '*') scope.stars.push({ module, at: first.from });
    const name = part.find((_token, at) => part[at - 1]?.text === 'as') ?? first;
    if (first?.kind !== 'name' || name?.kind !== 'name') continue;
    declare(scope, name, { kind: 'from', module, name: first.text });
  }
}

function bindFor(tokens: readonly Token[], scope: Scope): void {
  const place = topLevel(tokens, 'in');
  if (place < 0) return;
  const end = topLevel(tokens.slice(place), ':');
  const values = tokens.slice(place + 1, end < 0 ? undefined : place + end);
  const targets = tokens.slice(1, place).filter((token) => token.kind === 'name');
  for (const target of targets) {
    const known = targets.length === 1 ? values : [];
    declare(scope, target, { kind: 'value', of: 'element', tokens: known });
  }
}

function bindAs(tokens: readonly Token[], of: 'itself' | 'error', scope: Scope): void {
  const place = topLevel(tokens, 'as');
  const name = tokens[place + 1];
  if (place < 0 || name?.kind !== 'name') return;
  declare(scope, name, { kind: 'value', of, tokens: tokens.slice(0, place) });
}

const NO_STATEMENT_START = new Set(['if', 'elif', 'while', 'return', 'print', 'assert', 'raise', 'yield', 'del']);

function bindAssignment(tokens: readonly Token[], scope: Scope): void {
  if (NO_STATEMENT_START.has(tokens[0]?.text ?? '')) return;
  const targets: (readonly Token[])[] = [];
  let rest = tokens;
  for (;;) {
    const equals = topLevel(rest, '=');
    if (equals < 0) break;
    targets.push(rest.slice(0, equals));
    rest = rest.slice(equals + 1);
  }
  for (const target of targets) bindTarget(target, rest, scope);
}

function bindTarget(target: readonly Token[], value: readonly Token[], scope: Scope): void {
  const colon = topLevel(target, ':');
  const parts = splitAtCommas(colon < 0 ? target : target.slice(0, colon)).map(withoutBrackets);
  const values = splitAtCommas(value);
  for (const [place, part] of parts.entries()) {
    const tokens = parts.length === 1 ? value : values.length === parts.length ? (values[place] ?? []) : [];
    const binding: Binding = { kind: 'value', of: 'itself', tokens };
    const [first, dot, field] = part;
    if (first?.kind !== 'name') continue;
    if (part.length === 1) declare(scope, first, binding);
    if (part.length === 3 && first.text === 'self' && dot?.text === '.' && field?.kind === 'name') {
      classAround(scope)?.fields.push({ name: field.text, at: field.from, binding });
    }
  }
}

function withoutBrackets(tokens: readonly Token[]): readonly Token[] {
  return tokens.filter((token) => !(token.kind === 'operator' && '()[]'.includes(token.text)));
}

/** The class that a method's scope stands in. */
export function classAround(scope: Scope): Scope | null {
  return scope.kind === 'class' ? scope : scope.parent === null ? null : classAround(scope.parent);
}

function docOf({ tokens }: Statement): string | null {
  const [only] = tokens;
  if (tokens.length !== 1 || only?.kind !== 'string') return null;
  const text = only.text.replace(/^[a-zA-Z]*('''|"""|'|")/, '').replace(/('''|"""|'|")$/, '');
  const short = text.trim().replace(/\s*\n\s*/g, ' ');
  return short === '' ? null : short;
}
