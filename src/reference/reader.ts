import { argumentsOf, attributeOf, isSlice } from '#python/expressions';
import { namesOf, scopeAt, type Binding, type Bound, type Scope } from '#python/scopes';
import { childrenOf, readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';
import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import { opaque, Reference, renamed, type Meaning, type MeaningNames } from './meaning';

/** Limit for names that refer to one another in circles; no lesson comes near it. */
const MAX_STEPS = 3000;

/** Works out what the names and expressions of one source mean. */
export class Reader {
  private readonly root: Scope;
  private readonly known = new Map<Binding, Meaning | null>();
  private steps = 0;

  constructor(
    readonly source: PythonText,
    readonly context: ReferenceContext,
    readonly reference: Reference = new Reference(context),
    /** The module that this source is; `null` for the program that is being written. */
    private readonly file: string | null = null,
    private readonly importing: ReadonlySet<string> = new Set(),
  ) {
    this.root = namesOf(source).root;
  }

  scopeAt(offset: number): Scope {
    return scopeAt(this.root, this.source.text, offset);
  }

  /** All names that can be used at a place, the nearest meaning of each. */
  visible(scope: Scope, offset: number): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (let it: Scope | null = scope; it !== null; it = outer(it)) {
      const around: Scope = it;
      for (const { name, at } of around.names) {
        if (at !== offset && !names.has(name)) names.set(name, () => this.named(name, around, offset) ?? unknown(name));
      }
      for (const star of around.stars) {
        for (const [name, meaning] of this.module(star)?.names() ?? []) {
          if (!name.startsWith('_') && !names.has(name)) names.set(name, meaning);
        }
      }
    }
    for (const [name, meaning] of this.reference.builtins()) if (!names.has(name)) names.set(name, meaning);
    return names;
  }

  /** The meaning of a name at a place; `null` if the program does not have it. */
  lookup(name: string, scope: Scope, offset: number): Meaning | null {
    for (let it: Scope | null = scope; it !== null; it = outer(it)) {
      const found = this.named(name, it, offset);
      if (found !== null) return found;
      for (const star of [...it.stars].reverse()) {
        const meaning = this.module(star)?.names().get(name);
        if (meaning !== undefined) return meaning();
      }
    }
    return this.reference.builtins().get(name)?.() ?? null;
  }

  /** The module that `import name` loads: a file of the project, else a module of the board or robot. */
  module(name: string): Meaning | null {
    const source = this.context.files[`${name}.py`];
    if (source === undefined || name === 'main') return this.reference.module(name);
    if (this.importing.has(name)) return null;
    const reader = new Reader(
      readPython(source),
      this.context,
      this.reference,
      name,
      new Set([...this.importing, name]),
    );
    const item = itemOf({ label: name, kind: 'module', own: reader.docOf(reader.root), home: `${name}.py` });
    return { ...opaque(item), names: () => reader.scopeNames(reader.root) };
  }

  /** The value of an expression; `null` when unknown. */
  evaluate(node: SyntaxNode, scope: Scope): Meaning | null {
    this.steps += 1;
    if (this.steps > MAX_STEPS) return null;
    const { firstChild: first, lastChild: last } = node;
    const type = TYPES.get(node.name);
    if (type !== undefined) return this.builtin(type);
    switch (node.name) {
      case 'VariableName':
        return this.lookup(this.textOf(node), scope, node.from);
      case 'String':
        return this.builtin(/^[rR]?[bB]/.test(this.textOf(node)) ? 'bytes' : 'str');
      case 'Number':
        return this.builtin(/^0[xXbBoO]|^[^.eE]*$/.test(this.textOf(node)) ? 'int' : 'float');
      case 'ContinuedString':
      case 'ConditionalExpression':
        return first && this.evaluate(first, scope);
      case 'ParenthesizedExpression':
        return first?.nextSibling ? this.evaluate(first.nextSibling, scope) : null;
      case 'TupleExpression':
        return this.collection('tuple', first?.nextSibling, scope);
      case 'ArrayExpression':
        return this.collection('list', first?.nextSibling, scope);
      case 'UnaryExpression':
        return first?.name === 'not' ? this.builtin('bool') : last && this.evaluate(last, scope);
      case 'BinaryExpression':
        return first && last && this.calculated(first, last, scope);
      case 'CallExpression':
        return first && (this.evaluate(first, scope)?.called() ?? null);
      case 'MemberExpression':
        return first && this.member(node, first, scope);
      default:
        return null;
    }
  }

  /** The names of a scope as they appear after the dot of its module or class. */
  scopeNames(scope: Scope): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (const star of scope.stars) {
      for (const [name, meaning] of this.module(star)?.names() ?? []) names.set(name, meaning);
    }
    for (const { name } of scope.names) {
      names.set(name, () => this.named(name, scope, Infinity) ?? unknown(name));
    }
    return names;
  }

  private calculated(first: SyntaxNode, last: SyntaxNode, scope: Scope): Meaning | null {
    const operator = first.nextSibling;
    if (operator?.name === 'and' || operator?.name === 'or') return this.evaluate(first, scope);
    if (operator?.name !== 'ArithOp' && operator?.name !== 'BitOp') return this.builtin('bool');
    const left = this.evaluate(first, scope);
    if (left?.item.type !== 'int') return left;
    if (this.textOf(operator) === '/') return this.builtin('float');
    return this.evaluate(last, scope) ?? left;
  }

  private member(node: SyntaxNode, owner: SyntaxNode, scope: Scope): Meaning | null {
    const meaning = this.evaluate(owner, scope);
    const attribute = attributeOf(node);
    if (attribute !== null) return meaning?.names().get(this.textOf(attribute.property))?.() ?? null;
    return isSlice(node) ? meaning : (meaning?.element() ?? null);
  }

  private builtin(type: string): Meaning | null {
    return this.reference.instance(type);
  }

  private collection(type: string, first: SyntaxNode | null | undefined, scope: Scope): Meaning | null {
    const whole = this.builtin(type);
    if (whole === null || !first) return whole;
    return { ...whole, element: () => this.evaluate(first, scope) };
  }

  private textOf(node: SyntaxNode): string {
    return textOf(this.source, node);
  }

  /** The meaning of a name in one scope: the last known one before the place, else the first one after it. */
  private named(name: string, scope: Scope, offset: number): Meaning | null {
    const all = scope.names.filter((it) => it.name === name && it.at !== offset);
    const before = all.filter((it) => it.at < offset).reverse();
    const candidates = [...before, ...all.filter((it) => it.at > offset)];
    for (const bound of candidates) {
      const meaning = this.bound(bound, scope);
      if (meaning !== null) return meaning;
    }
    const [nearest] = candidates;
    if (nearest === undefined) return null;
    return opaque(this.ownItem(name, nearest.binding.kind === 'parameter' ? 'parameter' : 'variable', null));
  }

  private bound({ name, binding }: Bound, scope: Scope): Meaning | null {
    if (this.known.has(binding)) return this.known.get(binding) ?? null;
    this.known.set(binding, null); // a name that refers to itself is unknown there
    const meaning = this.meaningOf(name, binding, scope);
    this.known.set(binding, meaning);
    return meaning;
  }

  private meaningOf(name: string, binding: Binding, scope: Scope): Meaning | null {
    switch (binding.kind) {
      case 'import': {
        const { module, symbol } = binding;
        return symbol === null ? this.imported(module) : (this.module(module)?.names().get(symbol)?.() ?? null);
      }
      case 'function':
        return opaque(this.functionItem(binding.scope));
      case 'class':
        return this.classMeaning(binding.scope);
      case 'parameter':
        return this.own(name, 'parameter', this.parameter(name, binding, scope));
      case 'value': {
        const value = this.evaluate(binding.node, scope);
        const meaning = binding.of === 'element' ? value?.element() : binding.of === 'error' ? value?.called() : value;
        return this.own(name, 'variable', meaning ?? null);
      }
      case 'unknown':
        return null;
    }
  }

  /** A value under a name of the program's. */
  private own(name: string, kind: 'variable' | 'parameter', meaning: Meaning | null): Meaning | null {
    if (meaning === null) return null;
    // Another name for a function or class keeps its words: delay = sleep.
    if (meaning.item.calls.length > 0) return renamed(meaning, { ...meaning.item, label: name });
    return renamed(meaning, this.ownItem(name, kind, meaning.item.type));
  }

  private imported(path: string): Meaning | null {
    const [module = '', ...names] = path.split('.');
    let meaning = this.module(module);
    for (const name of names) meaning = meaning?.names().get(name)?.() ?? null;
    return meaning;
  }

  private parameter(
    name: string,
    { annotation, given }: Extract<Binding, { kind: 'parameter' }>,
    scope: Scope,
  ): Meaning | null {
    if (annotation !== null) return this.evaluate(annotation, scope)?.called() ?? null;
    if (given !== null) return this.evaluate(given, scope);
    const around = scope.parent?.kind === 'class' ? scope.parent : null;
    return around !== null && scope.names[0]?.name === name ? this.instanceOf(around) : null;
  }

  private functionItem(scope: Scope): Item {
    const list = scope.node.getChild('ParamList');
    const inside = list === null ? '' : this.textOf(list).replace(/^\(|\)$/g, '').trim(); // prettier-ignore
    const written = scope.parent?.kind === 'class' ? inside.replace(/^\w+(, )?/, '') : inside;
    const call = `(${written.replace(/\s+/g, ' ')})`;
    return { ...this.ownItem(scope.name, 'function', null), calls: [call], own: this.docOf(scope) };
  }

  /** The docstring of a function, class or file. */
  docOf({ kind, node }: Scope): string | null {
    const body = kind === 'module' ? node : node.getChild('Body');
    const first = childrenOf(body ?? node).find(({ name }) => name !== ':' && name !== 'Comment');
    const only = first?.name === 'ExpressionStatement' ? first.firstChild : null;
    if (only?.name !== 'String') return null;
    const text = this.textOf(only).replace(/^[a-zA-Z]*('''|"""|'|")/, '').replace(/('''|"""|'|")$/, ''); // prettier-ignore
    return text.trim().replace(/\s*\n\s*/g, ' ') || null;
  }

  private classMeaning(scope: Scope): Meaning {
    const start = this.classNames(scope).get('__init__')?.().item.calls ?? ['()'];
    return {
      item: { ...this.ownItem(scope.name, 'type', null), calls: start, own: this.docOf(scope) },
      names: () => this.classNames(scope),
      called: () => this.instanceOf(scope),
      element: () => null,
    };
  }

  private instanceOf(scope: Scope): Meaning {
    return {
      item: { ...this.ownItem(scope.name, 'value', scope.name), own: this.docOf(scope) },
      names: () => this.classNames(scope),
      called: () => null,
      element: () => null,
    };
  }

  private classNames(scope: Scope): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (const { value } of argumentsOf(this.source, scope.node)) {
      const base = value && this.evaluate(value, scope.parent ?? scope);
      for (const [name, meaning] of base?.names() ?? []) names.set(name, meaning);
    }
    for (const field of scope.fields) {
      names.set(field.name, () => this.bound(field, field.scope) ?? opaque(this.ownItem(field.name, 'variable', null)));
    }
    for (const [name, meaning] of this.scopeNames(scope)) names.set(name, meaning);
    return names;
  }

  private ownItem(label: string, kind: Item['kind'], type: string | null): Item {
    return itemOf({ label, kind, type, home: this.file === null ? null : `${this.file}.py` });
  }
}

/** Methods do not see the names of their class. */
const outer = ({ parent }: Scope): Scope | null => (parent?.kind === 'class' ? parent.parent : parent);

const unknown = (label: string): Meaning => opaque(itemOf({ label, kind: 'variable' }));

/** Expressions whose type is obvious. */
const TYPES: ReadonlyMap<string, string> = new Map(Object.entries({
  FormatString: 'str', Boolean: 'bool', ArrayComprehensionExpression: 'list', ComprehensionExpression: 'generator',
  SetExpression: 'set', SetComprehensionExpression: 'set',
  DictionaryExpression: 'dict', DictionaryComprehensionExpression: 'dict',
})); // prettier-ignore
