import { StateEffect, StateField, type EditorState } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';

/** Marks a line (counted from 1) as wrong; `null` takes the mark away. */
export const markWrongLine = StateEffect.define<number | null>();

const mark = Decoration.line({ class: 'cm-wrongLine' });

/** The line that is marked as wrong. Editing that line takes the mark away: the pupil is mending it. */
export const wrongLineField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marked, transaction) {
    let next = marked.map(transaction.changes);
    if (transaction.docChanged) next = withoutTouched(next, transaction.changes.desc, transaction.state);
    for (const effect of transaction.effects) {
      if (effect.is(markWrongLine)) next = markOf(effect.value, transaction.state);
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function markOf(line: number | null, state: EditorState): DecorationSet {
  if (line === null || line < 1 || line > state.doc.lines) return Decoration.none;
  return Decoration.set([mark.range(state.doc.line(line).from)]);
}

function withoutTouched(
  marked: DecorationSet,
  changes: { iterChangedRanges(f: (fromA: number, toA: number, fromB: number, toB: number) => void): void },
  state: EditorState,
): DecorationSet {
  const touched: [from: number, to: number][] = [];
  changes.iterChangedRanges((_fromA, _toA, fromB, toB) => touched.push([fromB, toB]));
  return marked.update({
    filter(from) {
      const line = state.doc.lineAt(from);
      return !touched.some(([start, end]) => start <= line.to && end >= line.from);
    },
  });
}
