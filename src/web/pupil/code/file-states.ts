import { isolateHistory } from '@codemirror/commands';
import { EditorState, type Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

import type { LineMarks } from './line-marks';

/** The state that the editor should show. */
export interface Shown {
  /** Unique among all files. */
  readonly key: string;
  readonly name: string;
  readonly text: string;
}

/** One editor for all tabs: every file keeps its own undo steps, cursor and scroll place while another one is shown. */
export class FileStates {
  readonly view: EditorView;
  private readonly hidden = new Map<string, { state: EditorState; top: number }>();
  private key: string;
  private name: string;

  constructor(
    parent: HTMLElement,
    shown: Shown,
    private readonly extensionsFor: (name: string) => Extension,
  ) {
    this.key = shown.key;
    this.name = shown.name;
    this.view = new EditorView({ parent, state: this.stateOf(shown) });
  }

  /** Shows a file; a text that was changed elsewhere replaces the one that was being edited. */
  show(shown: Shown): void {
    const { view } = this;
    if (shown.key !== this.key) {
      this.hidden.set(this.key, { state: view.state, top: view.scrollDOM.scrollTop });
      const kept = this.hidden.get(shown.key);
      this.key = shown.key;
      this.name = shown.name;
      view.setState(kept?.state ?? this.stateOf(shown));
      requestAnimationFrame(() => view.scrollDOM.scrollTo({ top: kept?.top ?? 0 }));
    }
    if (view.state.doc.toString() !== shown.text) view.setState(this.stateOf(shown));
  }

  /** Forgets files that are gone. */
  keepOnly(keys: readonly string[]): void {
    for (const key of this.hidden.keys()) if (!keys.includes(key)) this.hidden.delete(key);
  }

  /**
   * Makes the editor anew with this text and forgets all other files' states, for instance after a change of language.
   */
  refresh(text: string): void {
    this.hidden.clear();
    const { selection } = this.view.state;
    this.view.setState(EditorState.create({ doc: text, selection, extensions: this.extensionsFor(this.name) }));
  }

  /** Marks lines of the file that is shown, and none of it that were marked so before. */
  mark({ set }: LineMarks, lines: readonly number[]): void {
    this.view.dispatch({ effects: set.of(lines) });
  }

  /** Puts the cursor into a line and brings it into view. */
  jumpTo(line: number): void {
    const { view } = this;
    const { from } = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines));
    view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    view.focus();
  }

  /** Keeps the cursor in sight when the editor has become smaller while somebody types. */
  showCursor(): void {
    const { view } = this;
    if (view.hasFocus) view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main.head) });
  }

  /** Changes one text into another where they differ, as one step to undo; nothing if the text has changed since. */
  rewrite(before: string, after: string): void {
    const { view } = this;
    if (view.state.doc.toString() !== before) return;
    const shorter = Math.min(before.length, after.length);
    let from = 0;
    while (from < shorter && before[from] === after[from]) from += 1;
    let same = 0;
    while (same < shorter - from && before.at(-1 - same) === after.at(-1 - same)) same += 1;
    const insert = after.slice(from, after.length - same);
    view.dispatch({
      changes: { from, to: before.length - same, insert },
      selection: { anchor: from + insert.length },
      effects: EditorView.scrollIntoView(from, { y: 'center' }),
      annotations: isolateHistory.of('full'),
      userEvent: 'input',
    });
    view.focus();
  }

  destroy(): void {
    this.view.destroy();
  }

  private stateOf({ name, text }: Shown): EditorState {
    return EditorState.create({ doc: text, extensions: this.extensionsFor(name) });
  }
}
