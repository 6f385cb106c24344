import { snippet } from '@codemirror/autocomplete';
import { isolateHistory } from '@codemirror/commands';
import { indentUnit } from '@codemirror/language';
import type { EditorState, Line, Transaction, TransactionSpec } from '@codemirror/state';
import { childrenOf, readPython } from '#python/tree';

import { withImport } from '../../console/advice/import-line';
import type { Brought } from './bring-names';

/** Place where a command was dropped: in the text, on the upper or the lower half of its line. */
export interface Drop {
  readonly at: number;
  readonly isUpper: boolean;
}

/**
 * A command on a line of its own: below the cursor's line, or where it was dropped; one step further in after a colon;
 * in an empty line, that line. Missing imports come along, and no command comes to stand above the imports. The first
 * place to type over is marked, Tab goes on to the next. All this is one step to undo.
 */
export function insertion(state: EditorState, { code, imports }: Brought, drop: Drop | null = null): TransactionSpec {
  let now = state;
  let changes = state.changes();
  const change = (spec: TransactionSpec): void => {
    const step = now.update(spec);
    changes = changes.compose(step.changes);
    now = step.state;
  };
  for (const line of imports) change(importing(now, line));
  const asked = drop === null ? state.selection.main.head : drop.at;
  const at = makeRoom(now, changes.mapPos(asked, 1), drop?.isUpper === true);
  change({ changes: at.change, selection: { anchor: at.place } });
  const written = instantiate(now, code, at.place);
  const behind = at.place + written.newDoc.length - now.doc.length;
  return {
    changes: changes.compose(written.changes),
    selection: written.selection ?? { anchor: behind },
    effects: written.effects,
    annotations: isolateHistory.of('full'),
    userEvent: 'input.complete',
    scrollIntoView: true,
  };
}

/** The change that adds an import, as the help with errors adds it. */
function importing(state: EditorState, line: string): TransactionSpec {
  const before = state.doc.toString();
  const after = withImport(readPython(before), line);
  let from = 0;
  while (from < before.length && before[from] === after[from]) from += 1;
  return { changes: { from, insert: after.slice(from, from + after.length - before.length) } };
}

interface Room {
  readonly change: { readonly from: number; readonly to?: number; readonly insert: string };
  /** Start of the command, after the change. */
  readonly place: number;
}

/** An empty line with the indentation that belongs there. */
function makeRoom(state: EditorState, asked: number, isUpper: boolean): Room {
  const { doc } = state;
  const step = state.facet(indentUnit);
  const floor = endOfImports(doc.toString());
  const isAbove = asked < floor;
  const line = doc.lineAt(isAbove ? floor : asked);
  const inner = (it: Line): string => indentOf(it) + (opensBlock(it) ? step : '');
  if (line.text.trim() === '') {
    const before = line.number > 1 ? doc.line(line.number - 1) : null;
    const indent = line.text === '' && before !== null && opensBlock(before) ? inner(before) : line.text;
    return { change: { from: line.from, to: line.to, insert: indent }, place: line.from + indent.length };
  }
  if (isUpper && !isAbove) {
    const indent = indentOf(line);
    return { change: { from: line.from, insert: `${indent}\n` }, place: line.from + indent.length };
  }
  const next = line.number < doc.lines ? doc.line(line.number + 1) : null;
  // The line that an opened block waits with.
  if (next !== null && opensBlock(line) && next.text.trim() === '' && next.text.length > indentOf(line).length)
    return { change: { from: next.to, insert: '' }, place: next.to };
  const insert = `\n${inner(line)}`;
  return { change: { from: line.to, insert }, place: line.to + insert.length };
}

const indentOf = ({ text }: Line): string => /^[ \t]*/.exec(text)?.[0] ?? '';

const opensBlock = ({ text }: Line): boolean => /:\s*(#.*)?$/.test(text);

/** End of the imports at the start of a program; 0 without any. */
function endOfImports(text: string): number {
  const statements = childrenOf(readPython(text).tree.topNode).filter(({ name }) => name !== 'Comment');
  let end = 0;
  for (const [place, { name, to }] of statements.entries()) {
    if (name === 'ImportStatement') end = to;
    else if (place > 0 || name !== 'ExpressionStatement') break;
  }
  return end;
}

/** The library's expansion of a template at a place. */
function instantiate(state: EditorState, code: string, at: number): Transaction {
  let made: Transaction | null = null;
  snippet(code)({ state, dispatch: (transaction: Transaction) => void (made = transaction) }, null, at, at);
  return made ?? state.update({});
}
