import { childrenOf, readPython, type PythonText, type SyntaxNode } from './tree';

/** A part of a text that goes, and what stands there instead. */
interface Change {
  readonly from: number;
  readonly to: number;
  readonly with: string;
}

/**
 * The same program in fewer letters: without comments, docstrings, empty lines and spaces that mean nothing. Its names
 * and its behaviour stay; numbers of lines do not. A text with mistakes stays as it is.
 */
export function smallerPython(text: string): string {
  const unix = text.replace(/\r\n?/g, '\n');
  const source = readPython(unix);
  if (source.hasErrors) return text;
  const bare = readPython(applied(unix, [...commentsIn(source), ...docstringsIn(source)]));
  return bare.hasErrors ? text : withoutSpaces(bare);
}

/** The same text without comments and docstrings; each line stays in its place. A text with mistakes, too. */
export function uncommentedPython(text: string): string {
  const source = readPython(text);
  const lines = (change: Change): Change => ({
    ...change,
    with: change.with + text.slice(change.from, change.to).replace(/[^\r\n]/g, ''),
  });
  return applied(text, [...commentsIn(source), ...docstringsIn(source).map(lines)]);
}

function commentsIn({ tree }: PythonText): readonly Change[] {
  const changes: Change[] = [];
  tree.iterate({
    enter: ({ name, from, to }) => {
      if (name === 'Comment') changes.push({ from, to, with: '' });
    },
  });
  return changes;
}

/** Texts that stand alone at the beginning of a module, class or function. */
function docstringsIn({ tree }: PythonText): readonly Change[] {
  const changes: Change[] = [];
  tree.iterate({
    enter: ({ name, node }) => {
      if (name !== 'Script' && (name !== 'Body' || !isDefinition(node.parent))) return;
      const [first, second] = childrenOf(node).filter((child) => child.name !== 'Comment' && child.name !== ':');
      if (first === undefined || !isText(first)) return;
      changes.push({ from: first.from, to: first.to, with: second === undefined && name === 'Body' ? 'pass' : '' });
    },
  });
  return changes;
}

const isDefinition = (node: SyntaxNode | null): boolean =>
  node?.name === 'FunctionDefinition' || node?.name === 'ClassDefinition';

/** Several statements in one line stay: a semicolon would be left over. */
function isText(statement: SyntaxNode): boolean {
  const [only, another] = childrenOf(statement);
  return (
    statement.name === 'ExpressionStatement' &&
    another === undefined &&
    ['String', 'ContinuedString'].includes(only?.name ?? '') &&
    statement.nextSibling?.name !== ';'
  );
}

function applied(text: string, changes: readonly Change[]): string {
  let result = '';
  let at = 0;
  for (const change of changes.toSorted((a, b) => a.from - b.from)) {
    result += text.slice(at, change.from) + change.with;
    at = change.to;
  }
  return result + text.slice(at);
}

/** Signs beside which a space means nothing. */
const SIGNS = ',:;=+-*/%<>()[]{}&|^~@!';

/** Writes the leaves of the tree one after the other; each level of a block is one space. */
function withoutSpaces(source: PythonText): string {
  const leaves = leavesOf(source);
  const widths = [0];
  let depth = 0;
  let result = '';
  let end = 0;
  for (const { from, to } of leaves) {
    const [leaf, gap] = [source.text.slice(from, to), source.text.slice(end, from)];
    if (depth === 0 && (result === '' || gap.replaceAll('\\\n', '').includes('\n'))) {
      const width = gap.slice(gap.lastIndexOf('\n') + 1).length;
      while ((widths.at(-1) ?? 0) > width) widths.pop();
      if ((widths.at(-1) ?? 0) < width) widths.push(width);
      result += `${result === '' ? '' : '\n'}${' '.repeat(widths.length - 1)}`;
    } else if (gap !== '' && !SIGNS.includes(result.at(-1) ?? '') && !SIGNS.includes(leaf[0] ?? '')) result += ' ';
    result += leaf;
    if (leaf.length === 1 && '([{'.includes(leaf)) depth += 1;
    if (leaf.length === 1 && ')]}'.includes(leaf)) depth -= 1;
    end = to;
  }
  return `${result}\n`;
}

/** The smallest parts of a text by their places; a string is one. */
function leavesOf({ tree }: PythonText): readonly { readonly from: number; readonly to: number }[] {
  const leaves: { readonly from: number; readonly to: number }[] = [];
  tree.iterate({
    enter: ({ name, from, to, node }) => {
      const isString = name === 'String' || name === 'FormatString';
      if (!isString && node.firstChild !== null) return true;
      if (to > from) leaves.push({ from, to });
      return false;
    },
  });
  return leaves;
}
