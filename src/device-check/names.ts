import type { SyntaxNode } from '@lezer/common';

import { attributeOf, childrenOf, textOf, type SourceFile } from './source-file';

/** How a name came to mean something. Which function it is in is not looked at: doubt means no finding. */
export type Binding =
  | { readonly type: 'value'; readonly value: SyntaxNode }
  | { readonly type: 'loop'; readonly over: SyntaxNode }
  | { readonly type: 'import'; readonly module: string; readonly symbol: string | null }
  | { readonly type: 'function' }
  | { readonly type: 'other' };

/** One imported name. */
export interface Import {
  /** `math`; empty for `from . import x`. */
  readonly module: string;
  /** Where the module's name stands. */
  readonly moduleNode: SyntaxNode | null;
  /** What is taken out of the module; `*` for everything, `null` for the module itself. */
  readonly symbol: string | null;
  readonly symbolNode: SyntaxNode | null;
  /** What it is called in the file. */
  readonly as: string;
}

/** What the names of one file mean. */
export interface FileNames {
  readonly bindings: ReadonlyMap<string, readonly Binding[]>;
  readonly imports: readonly Import[];
  /** Names after a dot that the file itself gives a meaning: methods, class attributes, `self.name = …`. */
  readonly attributes: ReadonlySet<string>;
}

class Collector implements FileNames {
  readonly bindings = new Map<string, Binding[]>();
  readonly imports: Import[] = [];
  readonly attributes = new Set<string>();

  constructor(private readonly file: SourceFile) {
    file.tree.iterate({
      enter: ({ name, node }) => {
        this.visit(name, node);
      },
    });
  }

  private visit(name: string, node: SyntaxNode): void {
    switch (name) {
      case 'AssignStatement':
        return this.assignment(node);
      case 'UpdateStatement':
      case 'NamedExpression':
        return this.single(node);
      case 'FunctionDefinition':
      case 'ClassDefinition':
        return this.definition(node);
      case 'ParamList':
        return this.every(parameterNames(node), { type: 'other' });
      case 'ForStatement':
      case 'ArrayComprehensionExpression':
      case 'ComprehensionExpression':
      case 'SetComprehensionExpression':
      case 'DictionaryComprehensionExpression':
      case 'ArgList':
        return this.loops(node);
      case 'WithStatement':
      case 'TryStatement':
        return this.afterAs(node);
      case 'ImportStatement':
        return this.importStatement(node);
      default:
    }
  }

  private bind(node: SyntaxNode, binding: Binding): void {
    const name = textOf(this.file, node);
    const known = this.bindings.get(name);
    if (known === undefined) this.bindings.set(name, [binding]);
    else known.push(binding);
  }

  private every(names: readonly SyntaxNode[], binding: Binding): void {
    for (const name of names) this.bind(name, binding);
  }

  /** `a = b = 3`, `a, b = c`, `self.x = 1`, `x: int = 3`. */
  private assignment(node: SyntaxNode): void {
    const parts = splitBy(childrenOf(node), 'AssignOp').map((part) => part.filter(({ name }) => name !== 'TypeDef'));
    const values = parts.at(-1) ?? [];
    const value = values.length === 1 ? values[0] : undefined;
    for (const part of parts.slice(0, Math.max(1, parts.length - 1))) {
      const [target] = part;
      if (part.length === 1 && target?.name === 'VariableName') {
        this.bind(target, parts.length > 1 && value !== undefined ? { type: 'value', value } : { type: 'other' });
      } else for (const inner of part) this.target(inner);
    }
  }

  private target(node: SyntaxNode): void {
    if (node.name === 'VariableName') this.bind(node, { type: 'other' });
    const attribute = attributeOf(node);
    if (attribute !== null) this.attributes.add(textOf(this.file, attribute.property));
    else if (node.name !== 'MemberExpression') for (const child of childrenOf(node)) this.target(child);
  }

  /** `n += 1` and `(n := 1)`. */
  private single(node: SyntaxNode): void {
    const { firstChild: target, lastChild: value } = node;
    if (target?.name !== 'VariableName' || value === null) return;
    const divides = node.getChild('UpdateOp') !== null && textOf(this.file, node).includes('/='); // a float comes out
    this.bind(target, divides ? { type: 'other' } : { type: 'value', value });
  }

  private definition(node: SyntaxNode): void {
    const name = node.getChild('VariableName');
    if (name === null) return;
    this.bind(name, { type: 'function' });
    this.attributes.add(textOf(this.file, name));
    if (node.name !== 'ClassDefinition') return;
    for (const child of node.getChild('Body')?.getChildren('AssignStatement') ?? []) {
      if (child.firstChild?.name === 'VariableName') this.attributes.add(textOf(this.file, child.firstChild));
    }
  }

  /** Names between `for` and `in`, in statements and comprehensions. */
  private loops(node: SyntaxNode): void {
    const children = childrenOf(node);
    children.forEach((child, index) => {
      if (child.name !== 'for') return;
      const end = children.findIndex((it, at) => at > index && it.name === 'in');
      if (end < 0) return;
      const targets = children.slice(index + 1, end);
      const [target] = targets;
      const over = children[end + 1];
      if (targets.length === 1 && target?.name === 'VariableName' && over !== undefined) {
        this.bind(target, { type: 'loop', over });
      } else for (const it of targets) this.target(it);
    });
  }

  private afterAs(node: SyntaxNode): void {
    for (const as of node.getChildren('as')) if (as.nextSibling !== null) this.target(as.nextSibling);
  }

  private importStatement(node: SyntaxNode): void {
    const children = childrenOf(node).filter(({ name }) => name !== '(' && name !== ')');
    const split = children.findIndex(({ name }) => name === 'import');
    const from = children[0]?.name === 'from' ? children.slice(1, split < 0 ? undefined : split) : null;
    const first = from?.find(({ name }) => name === 'VariableName') ?? null;
    const module = from === null ? null : from.map((it) => textOf(this.file, it)).join('');
    for (const part of splitBy(children.slice(split + 1), ',')) this.importPart(part, module, first);
  }

  private importPart(part: readonly SyntaxNode[], module: string | null, moduleNode: SyntaxNode | null): void {
    const [first] = part;
    if (first === undefined) return;
    const as = part.findIndex(({ name }) => name === 'as');
    const named = part.slice(0, as < 0 ? undefined : as);
    const what = named.map((it) => textOf(this.file, it)).join('');
    const alias = as < 0 ? first : (part[as + 1] ?? first);
    const symbol = module === null ? null : what;
    const taken: Import = {
      module: module ?? what,
      moduleNode: module === null ? first : moduleNode,
      symbol,
      symbolNode: module === null ? null : first,
      as: textOf(this.file, alias),
    };
    this.imports.push(taken);
    if (alias.name === 'VariableName') this.bind(alias, { type: 'import', module: taken.module, symbol });
  }
}

/** Reads what the names of a file mean. */
export const namesOf = (file: SourceFile): FileNames => new Collector(file);

/** The names in brackets of `def` and after `lambda`; defaults and types are no names. */
function parameterNames(list: SyntaxNode): readonly SyntaxNode[] {
  const children = childrenOf(list);
  return children.filter((node, index) => node.name === 'VariableName' && children[index - 1]?.name !== 'AssignOp');
}

function splitBy(nodes: readonly SyntaxNode[], separator: string): readonly (readonly SyntaxNode[])[] {
  const parts: SyntaxNode[][] = [[]];
  for (const node of nodes) {
    if (node.name === separator) parts.push([]);
    else parts.at(-1)?.push(node);
  }
  return parts;
}
