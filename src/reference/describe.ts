import { attributeOf } from '#python/expressions';
import { childrenOf, readPython, textOf, type SyntaxNode } from '#python/tree';
import { calleeOf } from './arguments';
import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import { keywords } from './modules/keywords';
import { Reader } from './reader';

/** The facts about the name at a place. */
export interface Description {
  readonly from: number;
  readonly to: number;
  readonly item: Item;
  /** The argument in question, if the place is the name before `=` in a call. */
  readonly argument: string | null;
}

/** Describes the name at a place; `null` if there is none, or nothing is known about it. */
export function describe(text: string, offset: number, context: ReferenceContext): Description | null {
  const source = readPython(text);
  // A place right before the first letter counts as inside the word.
  for (const side of [1, -1] as const) {
    const node = source.tree.resolveInner(offset, side);
    const name = textOf(source, node);
    if (!isName(node, name)) continue;
    const found = itemAt(new Reader(source, context), node, name);
    return found && { from: node.from, to: node.to, ...found };
  }
  return null;
}

/** True for a word, even one that the parser cannot place, as after an unclosed bracket. */
const isName = ({ firstChild }: SyntaxNode, text: string): boolean =>
  firstChild === null && /^[\p{L}_][\p{L}\p{N}_]*$/u.test(text);

function itemAt(reader: Reader, node: SyntaxNode, name: string): Pick<Description, 'item' | 'argument'> | null {
  const argument = null;
  if (Object.hasOwn(keywords, name))
    return { item: itemOf({ label: name, kind: 'keyword', text: `keyword.${name}` }), argument };
  const { parent, nextSibling: next } = node;
  if (parent?.name === 'ImportStatement' && node.prevSibling?.name !== 'as') {
    const item = importedItem(reader, name, node, parent);
    return item && { item, argument };
  }
  if (parent?.name === 'ArgList' && next?.name === 'AssignOp') {
    const item = calleeOf(reader, parent);
    return item && { item, argument: name };
  }
  const scope = reader.scopeAt(node.from);
  const isProperty = parent !== null && attributeOf(parent)?.property.from === node.from;
  // Look after the statement: an assignment then shows the value that it gives.
  const meaning = isProperty ? reader.evaluate(parent, scope) : reader.lookup(name, scope, node.to);
  if (meaning === null) return null;
  return { item: meaning.item.label === name ? meaning.item : { ...meaning.item, label: name }, argument };
}

/** A name in an import. */
function importedItem(reader: Reader, name: string, { from }: SyntaxNode, statement: SyntaxNode): Item | null {
  const before = childrenOf(statement).filter((it) => it.from < from);
  const split = before.findIndex((it) => it.name === 'import');
  if (split <= 0) return reader.module(name)?.item ?? null;
  const module = before.slice(1, split).map((it) => textOf(reader.source, it));
  return reader.module(module.join(''))?.names().get(name)?.().item ?? null;
}
