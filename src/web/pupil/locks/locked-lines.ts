import { mdiLock } from '@mdi/js';
import { EditorState, RangeSetBuilder, StateField, type Extension } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';

import { keptLines } from '#check/task/kept-lines';

const picture = encodeURIComponent(
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="${mdiLock}"/></svg>`,
);

const look = EditorView.baseTheme({
  '.cm-lockedLine': { position: 'relative', backgroundColor: 'var(--surface-3)' },
  '.cm-line.cm-lockedLine': { paddingRight: '28px' },
  '.cm-lockedLine::after': {
    content: '""',
    position: 'absolute',
    right: '8px',
    top: '0',
    width: '14px',
    height: '1lh',
    backgroundColor: 'var(--text-3)',
    mask: `url("data:image/svg+xml,${picture}") center / 14px no-repeat`,
  },
});

/**
 * Refuses changes of locked lines in the editor, by whatever key, paste or command. A refused change leaves no step to
 * undo.
 *
 * @param lines their numbers in the text with which the editor begins
 * @param told title of a locked line
 * @param onRefused called when a change is refused
 */
export function lockedLines(lines: () => readonly number[], told: string, onRefused: () => void): Extension {
  const field = StateField.define<readonly number[]>({
    create: lines,
    update: (before, change) =>
      change.docChanged
        ? (keptLines(change.startState.doc.toString(), change.newDoc.toString(), before) ?? before)
        : before,
  });
  const mark = Decoration.line({ class: 'cm-lockedLine', attributes: { title: told } });
  return [
    field,
    look,
    EditorState.transactionFilter.of((change) => {
      if (!change.docChanged) return change;
      const { startState, newDoc } = change;
      if (keptLines(startState.doc.toString(), newDoc.toString(), startState.field(field)) !== null) return change;
      onRefused();
      return [];
    }),
    EditorView.decorations.compute([field, 'doc'], (state) => marks(state, state.field(field), mark)),
  ];
}

function marks(state: EditorState, lines: readonly number[], mark: Decoration): DecorationSet {
  const marked = new RangeSetBuilder<Decoration>();
  for (const line of lines) {
    if (line > state.doc.lines) continue;
    const { from } = state.doc.line(line);
    marked.add(from, from, mark);
  }
  return marked.finish();
}
