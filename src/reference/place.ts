import { childrenOf, parentsOf, readPython, readUpTo, textOf, type PythonText, type SyntaxNode } from '#python/tree';
import type { ReferenceContext } from './context';
import { Reader } from './reader';

/** A place in a program where something is being written. */
export interface Place {
  readonly reader: Reader;
  /** The letters and digits right before the place, and where they begin. */
  readonly typed: string;
  readonly from: number;
  /** The token in which the word begins: the word itself, or a comment or string around it. */
  readonly inside: SyntaxNode;
  /** The token before it in the same statement; `null` at the start of a statement. */
  readonly before: SyntaxNode | null;
}

/** Reads a program up to a place: half a line is easier to understand without what follows it. */
export function placeAt(text: string, offset: number, context: ReferenceContext): Place {
  const source = readPython(text);
  const typed = /[\p{L}\p{N}_]*$/u.exec(text.slice(text.lastIndexOf('\n', offset - 1) + 1, offset))?.[0] ?? '';
  const from = offset - typed.length;
  const start = readUpTo(source, from);
  const innermost = start.tree.resolveInner(from, 1);
  const inside = stringAround(innermost) ?? innermost;
  return { reader: new Reader(source, context), typed, from, inside, before: pieceBefore(start, inside) };
}

/** The string around a node; `null` for none. The braces of an f-string do not count as inside it. */
function stringAround(node: SyntaxNode): SyntaxNode | null {
  if (node.name === 'String' || node.name === 'FormatString') return node;
  return node.name === 'FormatReplacement' || node.parent === null ? null : stringAround(node.parent);
}

function pieceBefore(source: PythonText, node: SyntaxNode): SyntaxNode | null {
  const cursor = node.cursor();
  if (!cursor.prev(false)) return null;
  while (!isPiece(source, cursor.node)) if (!cursor.prev()) return null;
  const piece = cursor.node;
  const isNewLine = /(^|[^\\])\n/.test(source.text.slice(piece.to, node.from));
  return piece.name === ';' || (isNewLine && bracketsAround(piece).length === 0) ? null : piece;
}

/** The nodes whose brackets are still open after a token, innermost first. */
export const bracketsAround = (piece: SyntaxNode): readonly SyntaxNode[] =>
  Array.from(parentsOf(piece)).filter((node) => {
    const bracket = childrenOf(node).findLast(({ name }) => /^[()[\]{}]$/.test(name))?.name ?? ')';
    return '([{'.includes(bracket);
  });

/** True for a word, sign, number or string, but not a comment; strings have parts of their own. */
const isPiece = (source: PythonText, node: SyntaxNode): boolean =>
  node.name === 'String' || (node.firstChild === null && node.name !== 'Comment' && textOf(source, node).trim() !== '');
