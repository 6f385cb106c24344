import { childrenOf, readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';
import { linesOf, type Change, type HintKind } from './change';

/** A line of a program. */
export interface ProgramLine {
  /** From 1. */
  readonly number: number;
  readonly text: string;
  /** The spaces before it. */
  readonly indent: string;
  /** Its statement without comment; empty: it is none that stands in one line. */
  readonly code: string;
  /** `simple`: a statement that stands in this line; `head`: the first line of a block; `other`: neither. */
  readonly kind: 'simple' | 'head' | 'other';
  /** Type of the statement, as the syntax tree names it. */
  readonly statement: string;
}

/** A program that small changes are made to. */
export interface Program {
  readonly source: PythonText;
  readonly lines: readonly ProgramLine[];
  /** Number of the line with a place of the text. */
  readonly lineAt: (place: number) => number;
  /** A node of the tree of each of these names, in the order of the text. */
  readonly nodes: (...names: readonly string[]) => readonly SyntaxNode[];
  readonly textOf: (node: SyntaxNode) => string;
}

const HEADS = ['IfStatement', 'WhileStatement', 'ForStatement', 'FunctionDefinition', 'WithStatement', 'TryStatement'];

/** Reads a program. Code with mistakes is read as far as possible. */
export function readProgram(given: string): Program {
  const source = readPython(linesOf(given).join('\n'));
  const { text, tree } = source;
  const starts = [0];
  for (let at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) starts.push(at + 1);
  const lineAt = (place: number): number => starts.findLastIndex((start) => start <= place) + 1;
  const statements = new Map<number, SyntaxNode>();
  const heads = new Map<number, string>();
  const nodes: SyntaxNode[] = [];
  tree.iterate({
    enter: ({ node }) => {
      nodes.push(node);
      const { name, from, to } = node;
      if (isStatement(node) && lineAt(from) === lineAt(Math.max(from, to - 1))) statements.set(lineAt(from), node);
      else if (HEADS.includes(name)) heads.set(lineAt(from), name);
      if (name === 'elif' || name === 'else') heads.set(lineAt(from), name);
    },
  });
  const lines = linesOf(text).map((line, place): ProgramLine => {
    const number = place + 1;
    const [statement, head] = [statements.get(number), heads.get(number)];
    const kind = head !== undefined ? 'head' : statement !== undefined ? 'simple' : 'other';
    return {
      ...{ number, text: line, kind, indent: /^[ \t]*/.exec(line)?.[0] ?? '' },
      code: kind === 'simple' && statement !== undefined ? textOf(source, statement).trim() : '',
      statement: (kind === 'simple' ? statement?.name : head) ?? '',
    };
  });
  return {
    source,
    lines,
    lineAt,
    nodes: (...names) => nodes.filter(({ name }) => names.includes(name)),
    textOf: (node) => textOf(source, node),
  };
}

const isStatement = ({ name, parent }: SyntaxNode): boolean =>
  name.endsWith('Statement') && !HEADS.includes(name) && (parent?.name === 'Script' || parent?.name === 'Body');

/** A change of places within a line; `null`: the places are not in one line. */
export function replaced(
  { source, lines, lineAt }: Program,
  kind: HintKind,
  parts: readonly { readonly from: number; readonly to: number; readonly by: string }[],
  direction: Change['direction'] = null,
): Change | null {
  const [first] = parts;
  const last = parts.at(-1);
  if (first === undefined || last === undefined) return null;
  const line = lineAt(first.from);
  const text = lines[line - 1]?.text ?? '';
  if (line !== lineAt(last.to)) return null;
  const start = source.text.lastIndexOf('\n', first.from - 1) + 1;
  let after = text;
  for (const { from, to, by } of [...parts].reverse())
    after = after.slice(0, from - start) + by + after.slice(to - start);
  return { kind, line, before: [text], after: [after], direction };
}

/** True for the names of a comparison's signs. */
export const signOf = ({ source }: Program, node: SyntaxNode): SyntaxNode | null =>
  childrenOf(node).find((child) => ['CompareOp'].includes(child.name) && textOf(source, child) !== 'in') ?? null;
