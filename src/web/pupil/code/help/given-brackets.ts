import { pickedCompletion } from '@codemirror/autocomplete';
import { StateEffect, StateField, type Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

/** The bracket that was written for the pupil, by where it closes; `fresh` until the next key. */
interface Given {
  readonly close: number;
  readonly fresh: boolean;
}

const give = StateEffect.define<Given>();

const given = StateField.define<Given | null>({
  create: () => null,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(give)) return effect.value;
    if (value === null) return null;
    const close = transaction.changes.mapPos(value.close, 1);
    const { head } = transaction.state.selection.main;
    const gone = transaction.state.sliceDoc(close, close + 1) !== ')' || head > close;
    const line = transaction.state.doc.lineAt(close);
    return gone || head < line.from ? null : { close, fresh: value.fresh && !transaction.docChanged };
  },
});

/**
 * Writes `label()` in place of a word, the cursor between the brackets, or behind them when nothing belongs there.
 * Before a bracket only the label is written.
 */
export function insertCall(view: EditorView, label: string, from: number, to: number, hasParameters: boolean): void {
  const picked = pickedCompletion.of({ label });
  const start = from + label.length + 1;
  if (view.state.sliceDoc(to, to + 1) === '(') {
    const selection = { anchor: start };
    view.dispatch({
      changes: { from, to, insert: label },
      selection,
      annotations: picked,
      userEvent: 'input.complete',
    });
    return;
  }
  view.dispatch({
    changes: { from, to, insert: `${label}()` },
    selection: { anchor: hasParameters ? start : start + 1 },
    effects: hasParameters ? give.of({ close: start, fresh: true }) : [],
    annotations: picked,
    userEvent: 'input.complete',
    scrollIntoView: true,
  });
}

/** Pupils type brackets out of habit: the ones that are there already are passed over. */
const passOver = EditorView.inputHandler.of((view, from, to, text) => {
  const value = view.state.field(given);
  if (value === null || from !== to) return false;
  if (text === '(' && value.fresh && from === value.close) return true;
  if (text !== ')' || from !== value.close) return false;
  view.dispatch({ selection: { anchor: from + 1 }, userEvent: 'input.type' });
  return true;
});

export const givenBrackets: Extension = [given, passOver];
