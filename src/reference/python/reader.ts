import type { ReferenceContext } from '../context';
import { itemOf, type Item } from '../item';
import { opaque, Reference, renamed, type Meaning, type MeaningNames } from '../meaning';
import { closingOf } from './chain';
import { splitAtCommas, topLevel } from './statements';
import { classAround, scopeAt, survey, type Binding, type Bound, type Scope } from './survey';
import type { Token } from './tokens';

/** A limit for programs whose names refer to one another in circles of a size that no lesson has. */
const MAX_STEPS = 3000;

/** Finds out what the names and expressions of one source stand for. */
export class Reader {
  readonly root: Scope;
  private readonly known = new Map<Binding, Meaning | null>();
  private steps = 0;

  constructor(
    readonly source: string,
    readonly context: ReferenceContext,
    readonly reference: Reference = new Reference(context),
    /** The module that this source is; `null` for the program that is being written. */
    private readonly file: string | null = null,
    private readonly importing: ReadonlySet<string> = new Set(),
  ) {
    this.root = survey(source);
  }

  scopeAt(offset: number): Scope {
    return scopeAt(this.root, this.source, offset);
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
        for (const [name, meaning] of this.module(star.module)?.names() ?? []) {
          if (!name.startsWith('_') && !names.has(name)) names.set(name, meaning);
        }
      }
    }
    for (const [name, meaning] of this.reference.builtins()) if (!names.has(name)) names.set(name, meaning);
    return names;
  }

  /** What a name means at a place; `null` for a name that the program does not have. */
  lookup(name: string, scope: Scope, offset: number): Meaning | null {
    for (let it: Scope | null = scope; it !== null; it = outer(it)) {
      const found = this.named(name, it, offset);
      if (found !== null) return found;
      for (const star of [...it.stars].reverse()) {
        const meaning = this.module(star.module)?.names().get(name);
        if (meaning !== undefined) return meaning();
      }
    }
    return this.reference.builtins().get(name)?.() ?? null;
  }

  /** What `import name` loads: a file of the project, else a module of the board or robot. */
  module(name: string): Meaning | null {
    const source = this.context.files[`${name}.py`];
    if (source === undefined || name === 'main') return this.reference.module(name);
    if (this.importing.has(name)) return null;
    const reader = new Reader(source, this.context, this.reference, name, new Set([...this.importing, name]));
    const item = itemOf({ label: name, kind: 'module', own: reader.root.doc, home: `${name}.py` });
    return { ...opaque(item), names: () => reader.scopeNames(reader.root) };
  }

  /** The value of an expression that stands at the end of its pieces; `null` when unknown. */
  evaluate(tokens: readonly Token[], scope: Scope): Meaning | null {
    this.steps += 1;
    const [first] = tokens;
    if (first === undefined || this.steps > MAX_STEPS) return null;
    if (first.text === 'not') return this.builtin('bool');
    if (first.text === '-' || first.text === '+' || first.text === '~') return this.evaluate(tokens.slice(1), scope);
    const choice = topLevel(tokens, 'if', 'or', 'and');
    if (choice > 0) return this.evaluate(tokens.slice(0, choice), scope);
    if (topLevel(tokens, '==', '!=', '<', '>', '<=', '>=', 'in', 'is', 'not') > 0) return this.builtin('bool');
    const operator = topLevel(tokens, '+', '-', '*', '/', '//', '%', '**', '&', '|', '^', '<<', '>>');
    if (operator > 0) return this.calculated(tokens, operator, scope);
    return this.primary(tokens, scope);
  }

  /** The names of a scope as one sees them behind the dot of its module or class. */
  scopeNames(scope: Scope): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (const star of scope.stars) {
      for (const [name, meaning] of this.module(star.module)?.names() ?? []) names.set(name, meaning);
    }
    for (const { name } of scope.names) {
      names.set(name, () => this.named(name, scope, Infinity) ?? unknown(name));
    }
    return names;
  }

  private calculated(tokens: readonly Token[], operator: number, scope: Scope): Meaning | null {
    const left = this.evaluate(tokens.slice(0, operator), scope);
    if (left?.item.type !== 'int') return left;
    if (tokens[operator]?.text === '/') return this.builtin('float');
    return this.evaluate(tokens.slice(operator + 1), scope) ?? left;
  }

  private builtin(type: string): Meaning | null {
    return this.reference.instance(type);
  }

  private primary(tokens: readonly Token[], scope: Scope): Meaning | null {
    const [first] = tokens;
    if (first === undefined) return null;
    const opens = first.kind === 'operator' && '([{'.includes(first.text);
    let place = opens ? closingOf(tokens, 0) + 1 : 1;
    let meaning = opens ? this.bracketed(tokens.slice(0, place), scope) : this.atom(first, scope);
    while (place < tokens.length && meaning !== null) {
      const token = tokens[place];
      if (token?.text === '.') {
        meaning = meaning.names().get(tokens[place + 1]?.text ?? '')?.() ?? null;
        place += 2;
      } else if (token?.text === '(') {
        meaning = meaning.called();
        place = closingOf(tokens, place) + 1;
      } else if (token?.text === '[') {
        const close = closingOf(tokens, place);
        const isPart = topLevel(tokens.slice(place + 1, close), ':') >= 0;
        if (!isPart) meaning = meaning.element();
        place = close + 1;
      } else if (token?.kind === 'string') {
        place += 1;
      } else {
        return null;
      }
    }
    return meaning;
  }

  private atom({ kind, text, from }: Token, scope: Scope): Meaning | null {
    if (kind === 'string') return this.builtin(/^[rR]?[bB]/.test(text) ? 'bytes' : 'str');
    if (kind === 'number') return this.builtin(/^0[xXbBoO]/.test(text) || !/[.eE]/.test(text) ? 'int' : 'float');
    if (kind !== 'name') return null;
    if (text === 'True' || text === 'False') return this.builtin('bool');
    return this.lookup(text, scope, from);
  }

  private bracketed(tokens: readonly Token[], scope: Scope): Meaning | null {
    const inside = tokens.slice(1, tokens.at(-1)?.kind === 'operator' ? -1 : undefined);
    const parts = splitAtCommas(inside);
    const [first = []] = parts;
    const made = topLevel(inside, 'for') >= 0;
    switch (tokens[0]?.text) {
      case '(':
        if (parts.length === 1 && topLevel(inside, ',') < 0 && !made) return this.evaluate(inside, scope);
        return this.collection(made ? 'generator' : 'tuple', made ? [] : first, scope);
      case '[':
        return this.collection('list', made ? [] : first, scope);
      default:
        return this.builtin(topLevel(first, ':') >= 0 || inside.length === 0 ? 'dict' : 'set');
    }
  }

  private collection(type: string, first: readonly Token[], scope: Scope): Meaning | null {
    const whole = this.builtin(type);
    return whole === null ? null : { ...whole, element: () => this.evaluate(first, scope) };
  }

  /** The meaning of a name in one scope: the last one before the place that is understood, else the first one after. */
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
      case 'import':
        return this.imported(binding.module);
      case 'from':
        return this.module(binding.module)?.names().get(binding.name)?.() ?? null;
      case 'function':
        return opaque(this.functionItem(binding.scope));
      case 'class':
        return this.classMeaning(binding.scope);
      case 'parameter': {
        const meaning = this.parameter(name, binding.annotation, scope);
        return meaning === null ? null : renamed(meaning, this.ownItem(name, 'parameter', meaning.item.type));
      }
      case 'value': {
        const value = this.evaluate(binding.tokens, scope);
        const meaning = binding.of === 'element' ? value?.element() : binding.of === 'error' ? value?.called() : value;
        if (meaning === undefined || meaning === null) return null;
        // Another name for a function or class keeps its words: delay = sleep.
        if (meaning.item.calls.length > 0) return renamed(meaning, { ...meaning.item, label: name });
        return renamed(meaning, this.ownItem(name, 'variable', meaning.item.type));
      }
    }
  }

  private imported(path: string): Meaning | null {
    const [module = '', ...names] = path.split('.');
    let meaning = this.module(module);
    for (const name of names) meaning = meaning?.names().get(name)?.() ?? null;
    return meaning;
  }

  private parameter(name: string, annotation: readonly Token[], scope: Scope): Meaning | null {
    if (annotation.length > 0) return this.evaluate(annotation, scope)?.called() ?? null;
    const around = scope.parent?.kind === 'class' ? classAround(scope) : null;
    return around !== null && scope.names[0]?.name === name ? this.instanceOf(around) : null;
  }

  private functionItem(scope: Scope): Item {
    const isMethod = scope.parent?.kind === 'class';
    const call = isMethod ? scope.header.replace(/^\(\w+(, )?/, '(') : scope.header;
    return { ...this.ownItem(scope.name, 'function', null), calls: [call], own: scope.doc };
  }

  private classMeaning(scope: Scope): Meaning {
    const start = this.classNames(scope).get('__init__')?.().item.calls ?? ['()'];
    return {
      item: { ...this.ownItem(scope.name, 'type', null), calls: start, own: scope.doc },
      names: () => this.classNames(scope),
      called: () => this.instanceOf(scope),
      element: () => null,
    };
  }

  private instanceOf(scope: Scope): Meaning {
    return {
      item: { ...this.ownItem(scope.name, 'value', scope.name), own: scope.doc },
      names: () => this.classNames(scope),
      called: () => null,
      element: () => null,
    };
  }

  private classNames(scope: Scope): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (const base of scope.bases) {
      for (const [name, meaning] of this.evaluate(base, scope.parent ?? scope)?.names() ?? []) names.set(name, meaning);
    }
    for (const field of scope.fields) {
      names.set(field.name, () => {
        const home = this.scopeAt(field.at);
        return this.bound(field, home) ?? opaque(this.ownItem(field.name, 'variable', null));
      });
    }
    for (const [name, meaning] of this.scopeNames(scope)) names.set(name, meaning);
    return names;
  }

  private ownItem(label: string, kind: Item['kind'], type: string | null): Item {
    return itemOf({ label, kind, type, home: this.file === null ? null : `${this.file}.py` });
  }
}

/** Names of a class are not seen by its methods. */
const outer = ({ parent }: Scope): Scope | null => (parent?.kind === 'class' ? parent.parent : parent);

const unknown = (label: string): Meaning => opaque(itemOf({ label, kind: 'variable' }));
