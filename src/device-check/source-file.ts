import type { SyntaxNode, Tree } from '@lezer/common';
import { parser } from '@lezer/python';

/** A Python file and its syntax tree. What is written wrongly is in the tree as an error node, the rest around it. */
export interface SourceFile {
  readonly name: string;
  readonly text: string;
  readonly tree: Tree;
}

/** Reads a Python text. Never fails: half a line being typed is read as far as it goes. */
export function parseFile(name: string, text: string): SourceFile {
  return { name, text, tree: parser.parse(text) };
}

/** What is written at a node. */
export const textOf = (file: SourceFile, node: SyntaxNode): string => file.text.slice(node.from, node.to);

/** The nodes right below a node, in the order of the text. */
export function childrenOf(node: SyntaxNode): readonly SyntaxNode[] {
  const children: SyntaxNode[] = [];
  for (let child = node.firstChild; child !== null; child = child.nextSibling) children.push(child);
  return children;
}

/** The nodes around a node, the nearest first. */
export function* parentsOf(node: SyntaxNode): Generator<SyntaxNode> {
  for (let parent = node.parent; parent !== null; parent = parent.parent) yield parent;
}

/** Line and column of a place in a text, both counted from 1. Lines end as the editor and Python end them. */
export function placeOf(text: string, at: number): { readonly line: number; readonly column: number } {
  let line = 1;
  let start = 0;
  for (const end of text.matchAll(/\r\n?|\n/g)) {
    const next = end.index + end[0].length;
    if (next > at) break;
    line += 1;
    start = next;
  }
  return { line, column: at - start + 1 };
}

/** The end of a stretch of text, or of its first line where it goes on over several. */
export function endOnLine(text: string, from: number, to: number): number {
  const length = text.slice(from, to).search(/[\r\n]/);
  return length < 0 ? to : from + length;
}

/** The arguments of a call: `f(a, *b, c=1)`. */
export interface Argument {
  /** The value; `null` while it is being typed. */
  readonly value: SyntaxNode | null;
  readonly star: '' | '*' | '**';
  /** The word before `=`. */
  readonly keyword: string | null;
}

/** The arguments of a CallExpression in their order. */
export function argumentsOf(file: SourceFile, call: SyntaxNode): readonly Argument[] {
  const list = call.getChild('ArgList');
  if (list === null) return [];
  const found: Argument[] = [];
  let part: SyntaxNode[] = [];
  const close = (): void => {
    if (part.length > 0) found.push(argumentOf(file, part));
    part = [];
  };
  for (const child of childrenOf(list)) {
    if (child.name === ',' || child.name === ')') close();
    else if (child.name !== '(' && child.name !== 'Comment') part.push(child);
  }
  close();
  return found;
}

function argumentOf(file: SourceFile, part: readonly SyntaxNode[]): Argument {
  const [first, second] = part;
  if (first === undefined) return { value: null, star: '', keyword: null };
  if (first.name === '*' || first.name === '**') return { value: second ?? null, star: first.name, keyword: null };
  if (second?.name === 'AssignOp') return { value: part[2] ?? null, star: '', keyword: textOf(file, first) };
  return { value: first, star: '', keyword: null };
}

/** The last name of a chain of attributes and what stands before it: `display.show` is `display` and `show`. */
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

/** Whether a MemberExpression is a subscript with a colon in it: `a[1:3]`. */
export function isSlice(node: SyntaxNode): boolean {
  return node.name === 'MemberExpression' && node.lastChild?.name === ']' && node.getChild(':') !== null;
}
