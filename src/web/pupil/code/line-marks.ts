import { StateEffect, StateField, type EditorState, type Extension, type StateEffectType } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';

/** Marks of one kind on whole lines. */
export interface LineMarks {
  /** Marks these lines, counted from 1, and no others. */
  readonly set: StateEffectType<readonly number[]>;
  readonly field: Extension;
}

/** Lines that are wrong: an error names them. */
export const wrongLines = lineMarks('cm-wrongLine');

/** Lines that were written otherwise when the program was opened. */
export const changedLines = lineMarks('cm-changedLine');

/** Marks that go with their lines. Editing a marked line takes its mark away: the pupil has seen it. */
function lineMarks(name: string): LineMarks {
  const set = StateEffect.define<readonly number[]>();
  const mark = Decoration.line({ class: name });
  const field = StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(marked, transaction) {
      let next = marked.map(transaction.changes);
      if (transaction.docChanged) next = withoutTouched(next, transaction.changes.desc, transaction.state);
      for (const effect of transaction.effects) {
        if (effect.is(set)) next = marksOf(mark, effect.value, transaction.state);
      }
      return next;
    },
    provide: (it) => EditorView.decorations.from(it),
  });
  return { set, field };
}

function marksOf(mark: Decoration, lines: readonly number[], { doc }: EditorState): DecorationSet {
  const there = lines.filter((line) => line >= 1 && line <= doc.lines);
  return Decoration.set(
    there.map((line) => mark.range(doc.line(line).from)),
    true,
  );
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
