import { EditorView } from '@codemirror/view';

import type { Command } from './commands';
import { insertionOf } from './insert-command';

/** Writes a command into the program that is shown, at the cursor. Returns whether there was an editor to take it. */
export function insertIntoEditor(command: Command): boolean {
  const host = document.querySelector<HTMLElement>('[data-testid="editor"] .cm-editor');
  const view = host === null ? null : EditorView.findFromDOM(host);
  if (view === null) return false;
  const { from, to } = view.state.selection.main;
  const { changes, select } = insertionOf(view.state.doc.toString(), from, to, command);
  view.dispatch({ changes, selection: select, scrollIntoView: true, userEvent: 'input.complete' });
  return true;
}
