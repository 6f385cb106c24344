import { attributeOf } from './expressions';
import { importsIn, type Import } from './imports';
import { childrenOf, splitBy, textOf, type PythonText, type SyntaxNode } from './tree';

/** The form in which a name is bound in a scope. */
export type Binding =
  /** `symbol` is the name imported from the module; `null` for the module itself. */
  | { readonly kind: 'import'; readonly module: string; readonly symbol: string | null }
  | { readonly kind: 'function' | 'class'; readonly scope: Scope }
  | { readonly kind: 'parameter'; readonly annotation: SyntaxNode | null; readonly given: SyntaxNode | null }
  /** The value of an expression; `element`: one of its elements, by `for`; `error`: what `except` caught. */
  | { readonly kind: 'value'; readonly of: 'itself' | 'element' | 'error'; readonly node: SyntaxNode }
  | { readonly kind: 'unknown' };

/** A name with its place. */
export interface Bound {
  readonly name: string;
  readonly at: number;
  readonly binding: Binding;
}

/** A part of the program with names of its own. */
export interface Scope {
  readonly kind: 'module' | 'function' | 'class' | 'lambda' | 'comprehension';
  readonly name: string;
  readonly node: SyntaxNode;
  /** Indentation of its first line. */
  readonly indent: number;
  /** Start of the first statement after it. */
  to: number;
  readonly parent: Scope | null;
  readonly inner: Scope[];
  readonly names: Bound[];
  /** Instance attributes: what methods assign to `self.x`. */
  readonly fields: (Bound & { readonly scope: Scope })[];
  /** Names that a function declares `global`. */
  readonly globals: Set<string>;
  /** Modules imported by `from … import *`. */
  readonly stars: string[];
}

/** The names of a program and their meaning. */
export interface ProgramNames {
  /** The scope of the module. */
  readonly root: Scope;
  /** Every binding of each name, in any scope. */
  readonly bindings: ReadonlyMap<string, readonly Binding[]>;
  readonly imports: readonly Import[];
  /** Attributes that the program itself defines: methods, class attributes, `self.name = …`. */
  readonly attributes: ReadonlySet<string>;
}

const known = new WeakMap<PythonText, ProgramNames>();

/** Finds the names of a program and where they are bound. Code that it does not understand is left out. */
export function namesOf(source: PythonText): ProgramNames {
  const names = known.get(source) ?? new Collector(source);
  known.set(source, names);
  return names;
}

/** The innermost scope at a place: a line that is not indented more than `def` is outside of it. */
export function scopeAt(root: Scope, text: string, offset: number): Scope {
  const indent = indentAt(text, offset);
  const lineStart = text.lastIndexOf('\n', offset - 1) + 1;
  let scope = root;
  for (;;) {
    const inner = scope.inner.find(({ kind, node, to, indent: outside }) => {
      if (node.from > offset || offset > to) return false;
      return kind === 'lambda' || kind === 'comprehension' || node.from >= lineStart || indent > outside;
    });
    if (inner === undefined) return scope;
    scope = inner;
  }
}

/** The class that a scope is or belongs to. */
export function classAround(scope: Scope): Scope | null {
  if (scope.kind === 'class') return scope;
  return scope.parent === null ? null : classAround(scope.parent);
}

/** Indentation of the line at a place; a tab counts up to the next multiple of four. */
function indentAt(text: string, offset: number): number {
  const start = text.lastIndexOf('\n', offset - 1) + 1;
  let indent = 0;
  for (let at = start; text[at] === ' ' || text[at] === '\t'; at += 1) {
    indent = text[at] === '\t' ? indent - (indent % 4) + 4 : indent + 1;
  }
  return indent;
}

const UNKNOWN: Binding = { kind: 'unknown' };

class Collector implements ProgramNames {
  readonly root: Scope;
  readonly bindings = new Map<string, Binding[]>();
  readonly imports: Import[] = [];
  readonly attributes = new Set<string>();
  private scope: Scope;

  constructor(private readonly source: PythonText) {
    const { text, tree } = source;
    this.root = newScope('module', '', tree.topNode, -1, text.length, null);
    this.scope = this.root;
    tree.iterate({
      enter: (ref) => {
        if (/(Statement|Definition)$/.test(ref.name)) this.leaveScopes(ref.from);
        VISITS.get(ref.name)?.(this, ref.node);
      },
      leave: ({ name, from, to }) => {
        const { kind, node, parent } = this.scope;
        const isExpression = kind === 'lambda' || kind === 'comprehension';
        if (isExpression && parent !== null && node.name === name && node.from === from && node.to === to)
          this.scope = parent;
      },
    });
  }

  /**
   * A line indented wrongly ends a function in the tree; here the function continues as long as lines are indented
   * more.
   */
  private leaveScopes(from: number): void {
    const indent = indentAt(this.source.text, from);
    while (this.scope.parent !== null && from >= this.scope.node.to && indent <= this.scope.indent) {
      this.scope.to = from;
      this.scope = this.scope.parent;
    }
  }

  private open(kind: Scope['kind'], name: string, node: SyntaxNode): Scope {
    const { text } = this.source;
    const to = kind === 'lambda' ? node.to : kind === 'comprehension' ? node.to - 1 : text.length;
    const scope = newScope(kind, name, node, indentAt(text, node.from), to, this.scope);
    this.scope.inner.push(scope);
    return scope;
  }

  private textOf(node: SyntaxNode): string {
    return textOf(this.source, node);
  }

  /** Adds a name to its scope, or to the module's if the function declared it `global`. */
  private declare(node: SyntaxNode, binding: Binding): void {
    const name = this.textOf(node);
    const scope = this.scope.globals.has(name) ? this.root : this.scope;
    scope.names.push({ name, at: node.from, binding });
    if (scope.kind === 'class') this.attributes.add(name);
    this.note(name, binding);
  }

  private note(name: string, binding: Binding): void {
    const before = this.bindings.get(name);
    if (before === undefined) this.bindings.set(name, [binding]);
    else before.push(binding);
  }

  definition(node: SyntaxNode): void {
    const kind = node.name === 'ClassDefinition' ? 'class' : 'function';
    const nameNode = node.getChild('VariableName');
    if (nameNode === null) return;
    const name = this.textOf(nameNode);
    const scope = this.open(kind, name, node);
    this.declare(nameNode, { kind, scope });
    this.attributes.add(name);
    this.scope = scope;
  }

  lambda(node: SyntaxNode): void {
    this.scope = this.open('lambda', '', node);
  }

  /** The parameters of `def` and `lambda`. */
  parameters(list: SyntaxNode): void {
    const inside = childrenOf(list).filter(({ name }) => !['(', ')', '*', '**', '/'].includes(name));
    for (const [name, ...rest] of splitBy(inside, ',')) {
      if (name?.name !== 'VariableName') continue;
      const annotation = rest.find((it) => it.name === 'TypeDef')?.lastChild ?? null;
      const equals = rest.findIndex((it) => it.name === 'AssignOp');
      const given = equals < 0 ? null : (rest[equals + 1] ?? null);
      this.declare(name, { kind: 'parameter', annotation, given });
    }
  }

  /** `a = b = 3`, `a, b = c`, `self.x = 1`, `x: int = 3`. */
  assignment(node: SyntaxNode): void {
    const written = childrenOf(node).filter(({ name }) => name !== 'TypeDef');
    const parts = splitBy(written, 'AssignOp');
    const [first] = written;
    for (const part of parts.slice(0, -1)) this.targets(part, parts.at(-1) ?? []);
    // `x: int` alone binds no name, and the line may be half typed: it only casts doubt on x.
    if (parts.length === 1 && first?.name === 'VariableName') this.note(this.textOf(first), UNKNOWN);
  }

  private targets(part: readonly SyntaxNode[], value: readonly SyntaxNode[]): void {
    const targets = elementsOf(part);
    const values = targets.length === 1 ? [value] : splitBy(value, ',');
    for (const [place, target] of targets.entries()) {
      const [node, ...more] = values.length === targets.length ? (values[place] ?? []) : [];
      this.target(target, node === undefined || more.length > 0 ? UNKNOWN : { kind: 'value', of: 'itself', node });
    }
  }

  private target(node: SyntaxNode, binding: Binding): void {
    if (node.name === 'VariableName') return this.declare(node, binding);
    if (isBracketed(node)) return elementsOf([node]).forEach((element) => this.target(element, UNKNOWN));
    const attribute = attributeOf(node);
    if (attribute === null) return;
    const { owner, property } = attribute;
    const { scope } = this;
    const name = this.textOf(property);
    this.attributes.add(name);
    if (this.textOf(owner) === 'self') classAround(scope)?.fields.push({ name, at: property.from, binding, scope });
  }

  /** `n += 1` does not bind a new name, but shows what it may be afterwards. */
  update({ firstChild: target, lastChild: node }: SyntaxNode): void {
    if (target?.name !== 'VariableName' || node === null) return;
    const isDivision = node.prevSibling !== null && this.textOf(node.prevSibling) === '/='; // the result is a float
    this.note(this.textOf(target), isDivision ? UNKNOWN : { kind: 'value', of: 'itself', node });
  }

  /** `(n := 1)` */
  walrus({ firstChild: target, lastChild: node }: SyntaxNode): void {
    if (target !== null && node !== null) this.target(target, { kind: 'value', of: 'itself', node });
  }

  /** A comprehension, in its own brackets or in a call's. An unclosed bracket may have swallowed the line of a loop. */
  comprehension(node: SyntaxNode): void {
    if (node.getChild('for') === null) return;
    if (node.getChild('⚠') === null) this.scope = this.open('comprehension', '', node);
    this.loops(node);
  }

  /** Names between `for` and `in`. */
  loops(node: SyntaxNode): void {
    const children = childrenOf(node);
    for (const [place, { name }] of children.entries()) {
      const end = children.findIndex((it, at) => at > place && it.name === 'in');
      if (name !== 'for' || end < 0) continue;
      const targets = elementsOf(children.slice(place + 1, end));
      const over = children[end + 1];
      const isKnown = targets.length === 1 && over !== undefined && !over.type.isError;
      for (const target of targets)
        this.target(target, isKnown ? { kind: 'value', of: 'element', node: over } : UNKNOWN);
    }
  }

  /** Names after `as` in `with` and `except`. */
  afterAs(statement: SyntaxNode, of: 'itself' | 'error'): void {
    for (const { prevSibling: node, nextSibling: target } of statement.getChildren('as'))
      if (target !== null) this.target(target, node === null ? UNKNOWN : { kind: 'value', of, node });
  }

  importStatement(statement: SyntaxNode): void {
    for (const it of importsIn(this.source, statement)) {
      const { module, symbol, symbolNode, nameNode, moduleNode } = it;
      this.imports.push(it);
      if (symbol === '*') this.scope.stars.push(module);
      if (nameNode === null) continue;
      // `import a.b` binds a; the names behind the dot are found through it.
      const isShort = symbolNode === null && nameNode.from === moduleNode?.from;
      this.declare(nameNode, { kind: 'import', module: isShort ? this.textOf(nameNode) : module, symbol });
    }
  }

  global(statement: SyntaxNode): void {
    if (statement.firstChild?.name !== 'global') return;
    for (const name of statement.getChildren('VariableName')) this.scope.globals.add(this.textOf(name));
  }
}

const VISITS: ReadonlyMap<string, (names: Collector, node: SyntaxNode) => void> = new Map([
  ['FunctionDefinition', (names, node) => names.definition(node)],
  ['ClassDefinition', (names, node) => names.definition(node)],
  ['LambdaExpression', (names, node) => names.lambda(node)],
  ['ParamList', (names, node) => names.parameters(node)],
  ['AssignStatement', (names, node) => names.assignment(node)],
  ['UpdateStatement', (names, node) => names.update(node)],
  ['NamedExpression', (names, node) => names.walrus(node)],
  ['ForStatement', (names, node) => names.loops(node)],
  ['ArrayComprehensionExpression', (names, node) => names.comprehension(node)],
  ['ComprehensionExpression', (names, node) => names.comprehension(node)],
  ['SetComprehensionExpression', (names, node) => names.comprehension(node)],
  ['DictionaryComprehensionExpression', (names, node) => names.comprehension(node)],
  ['ArgList', (names, node) => names.comprehension(node)],
  ['WithStatement', (names, node) => names.afterAs(node, 'itself')],
  ['TryStatement', (names, node) => names.afterAs(node, 'error')],
  ['ImportStatement', (names, node) => names.importStatement(node)],
  ['ScopeStatement', (names, node) => names.global(node)],
]);

const isBracketed = ({ name }: SyntaxNode): boolean => /^(Tuple|Array|Parenthesized)Expression$/.test(name);

/** The targets of `a, b` and of `(a, b)` and `[a, b]`. */
function elementsOf(part: readonly SyntaxNode[]): readonly SyntaxNode[] {
  const [only] = part;
  const inside = part.length === 1 && only !== undefined && isBracketed(only) ? childrenOf(only) : part;
  return inside.filter(({ name, type }) => !type.isError && !['(', ')', '[', ']', ','].includes(name));
}

function newScope(
  kind: Scope['kind'],
  name: string,
  node: SyntaxNode,
  indent: number,
  to: number,
  parent: Scope | null,
): Scope {
  const lists = { inner: [], names: [], fields: [], globals: new Set<string>(), stars: [] };
  return { kind, name, node, indent, to, parent, ...lists };
}
