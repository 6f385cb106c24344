import { TreeFragment, type SyntaxNode, type Tree } from '@lezer/common';
import { parser } from '@lezer/python';

export type { SyntaxNode };

/** A Python text with its syntax tree. Wrong code is an error node `⚠` in the tree, with the rest around it. */
export interface PythonText {
  readonly text: string;
  readonly tree: Tree;
  readonly hasErrors: boolean;
}

/** Number of texts that are remembered. Chosen: more than a project has files. */
const REMEMBERED = 32;

/** The texts read last, the latest at the end. It only saves time: a text gives the same tree without it. */
const readings = new Map<string, PythonText>();

/**
 * Parses a Python text. Never fails: a line being typed is parsed as far as possible. The same text is parsed once,
 * and a text that differs little from an earlier one is parsed around the difference only.
 */
export function readPython(text: string): PythonText {
  return remember(readings.get(text) ?? parsePython(text, unchangedParts(text)));
}

/** Parses the text before a place, with a one-letter name put at the place, so that what is written there reads as a name. */
export function readUpTo({ text, tree }: PythonText, place: number): PythonText {
  const change = { fromA: place, toA: text.length, fromB: place, toB: place + 1 };
  const before = `${text.slice(0, place)}_`;
  return parsePython(before, TreeFragment.applyChanges(TreeFragment.addTree(tree), [change]));
}

/** Parses a text without remembering it. */
export function parsePython(text: string, unchanged: readonly TreeFragment[] = []): PythonText {
  const tree = parser.parse(text, unchanged);
  return { text, tree, hasErrors: hasErrors(tree) };
}

function remember(reading: PythonText): PythonText {
  readings.delete(reading.text);
  readings.set(reading.text, reading);
  for (const oldest of readings.keys()) {
    if (readings.size <= REMEMBERED) break;
    readings.delete(oldest);
  }
  return reading;
}

/** The parts that this text shares with an earlier one, if they are more than half of it. */
function unchangedParts(text: string): readonly TreeFragment[] {
  for (const reading of Array.from(readings.values()).reverse()) {
    // Around an error the parser has guessed: from there it might guess otherwise than it would from the start.
    if (reading.hasErrors) continue;
    const before = reading.text;
    const shorter = Math.min(text.length, before.length);
    let start = 0;
    while (start < shorter && text.charCodeAt(start) === before.charCodeAt(start)) start += 1;
    let end = 0;
    while (
      end < shorter - start &&
      text.charCodeAt(text.length - 1 - end) === before.charCodeAt(before.length - 1 - end)
    )
      end += 1;
    if (2 * (start + end) <= text.length) continue;
    remember(reading);
    const change = { fromA: start, toA: before.length - end, fromB: start, toB: text.length - end };
    return TreeFragment.applyChanges(TreeFragment.addTree(reading.tree), [change]);
  }
  return [];
}

function hasErrors(tree: Tree): boolean {
  const cursor = tree.cursor();
  do if (cursor.type.isError) return true;
  while (cursor.next());
  return false;
}

/** The text of a node. */
export const textOf = ({ text }: PythonText, { from, to }: SyntaxNode): string => text.slice(from, to);

/** The children of a node, in the order of the text. */
export function childrenOf(node: SyntaxNode): readonly SyntaxNode[] {
  const children: SyntaxNode[] = [];
  for (let child = node.firstChild; child !== null; child = child.nextSibling) children.push(child);
  return children;
}

/** The ancestors of a node, nearest first. */
export function* parentsOf(node: SyntaxNode): Generator<SyntaxNode> {
  for (let parent = node.parent; parent !== null; parent = parent.parent) yield parent;
}

/** Nodes between separators such as `,`. */
export function splitBy(nodes: readonly SyntaxNode[], separator: string): readonly (readonly SyntaxNode[])[] {
  const parts: SyntaxNode[][] = [[]];
  for (const node of nodes) {
    if (node.name === separator) parts.push([]);
    else parts.at(-1)?.push(node);
  }
  return parts;
}
