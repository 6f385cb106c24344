import { childrenOf, splitBy, textOf, type PythonText, type SyntaxNode } from './tree';

/** One argument of a call `f(a, *b, c=1)`. */
export interface Argument {
  /** The value; `null` while it is being typed. */
  readonly value: SyntaxNode | null;
  readonly star: '' | '*' | '**';
  /** The word before `=`. */
  readonly keyword: string | null;
}

/** The arguments of a CallExpression, or the bases of a ClassDefinition, in their order. */
export function argumentsOf(source: PythonText, call: SyntaxNode): readonly Argument[] {
  const list = call.getChild('ArgList');
  const inside = list === null ? [] : childrenOf(list).filter(({ name }) => !['(', ')', 'Comment'].includes(name));
  return splitBy(inside, ',').filter((part) => part.length > 0).map((part) => argumentOf(source, part)); // prettier-ignore
}

function argumentOf(source: PythonText, [first, second, third]: readonly SyntaxNode[]): Argument {
  if (first === undefined) return { value: null, star: '', keyword: null };
  if (first.name === '*' || first.name === '**') return { value: second ?? null, star: first.name, keyword: null };
  if (second?.name === 'AssignOp') return { value: third ?? null, star: '', keyword: textOf(source, first) };
  return { value: first, star: '', keyword: null };
}

/** The last name of a chain of attributes and the part before it: `display.show` is `display` and `show`. */
export interface Attribute {
  readonly owner: SyntaxNode;
  readonly property: SyntaxNode;
}

/** A MemberExpression that ends in a name; `null` for a subscript. */
export function attributeOf(node: SyntaxNode): Attribute | null {
  const { firstChild: owner, lastChild: property } = node;
  return node.name === 'MemberExpression' && owner !== null && property?.name === 'PropertyName'
    ? { owner, property }
    : null;
}

/** True if a MemberExpression is a subscript with a colon: `a[1:3]`. */
export function isSlice(node: SyntaxNode): boolean {
  return node.name === 'MemberExpression' && node.getChild(':') !== null;
}
