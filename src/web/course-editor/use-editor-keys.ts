import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';
import type { CourseEditorParts } from './state/parts';
import { toolOfLetter } from './palette/tool-list';
import type { useSelectionActs } from './state/use-selection-acts';

/** Letters that press buttons of the board while a program runs. */
const BOARD_LETTERS = ['a', 'b', 'l'];

/**
 * The editor's keyboard shortcuts. Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z work on the whole page except in text fields;
 * letters choose tools while the arena, the palette or the head has the focus. While a program runs and the hand is
 * chosen, A, B and L belong to the board. In the arena the drawing surface handles the other keys for the selection;
 * elsewhere on the page Delete and Ctrl with C, X, V, D and A are handled here, as long as the selection is visible.
 */
export function useEditorKeys(app: Pick<RunParts, 'run'> & WorkParts & Pick<CourseEditorParts, 'editor'>): void {
  const { editor, run } = app;
  const last = useLastPlace();
  /** The actions for a selection, loaded with the first one. */
  function withActs(act: (acts: ReturnType<typeof useSelectionActs>) => void): void {
    import('./state/use-selection-acts').then(({ useSelectionActs: make }) => act(make(app))).catch(() => undefined); // offline, nothing happens
  }

  function letter(key: string): boolean {
    if (run.isActive.value && editor.tool.value === 'hand' && BOARD_LETTERS.includes(key)) return false;
    const tool = toolOfLetter(key);
    if (tool === undefined) return false;
    editor.choose(tool);
    return true;
  }

  function withControl(key: string, shift: boolean): boolean {
    if (key === 'z' && shift) editor.redo();
    else if (key === 'z') editor.undo();
    else if (key === 'y' && !shift) editor.redo();
    else return false;
    return true;
  }

  function besideArena(key: string, control: boolean): boolean {
    const act = control ? commandOf(key, editor, last.value) : removes(key, editor) ? 'remove' : null;
    if (act === null) return false;
    withActs((acts) => acts[act]());
    return true;
  }

  function down(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.altKey || takesKeys(event.target)) return;
    const place = event.target instanceof Element ? event.target.closest('[data-editor-keys]') : null;
    const key = event.key.toLowerCase();
    const control = event.ctrlKey || event.metaKey;
    const isInArena = event.target instanceof Element && event.target.closest('[role="application"]') !== null;
    const done =
      (control && withControl(key, event.shiftKey)) ||
      (editor.isOpen.value && !isInArena && last.value !== 'console' && !event.shiftKey && besideArena(key, control)) ||
      (editor.isOpen.value && place !== null && !control && !event.shiftKey && !event.repeat && letter(key));
    if (!done) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  addEventListener('keydown', down, true);
  onScopeDispose(() => removeEventListener('keydown', down, true));
}

type Editor = CourseEditorParts['editor'];
const hasSelection = ({ selection }: Editor): boolean => selection.value.ids.length > 0;
const removes = (key: string, editor: Editor): boolean =>
  (key === 'delete' || key === 'backspace') && hasSelection(editor);

/** What a key does together with Ctrl; `null` leaves it to the browser. */
function commandOf(
  key: string,
  editor: Editor,
  last: Place,
): 'selectAll' | 'copy' | 'cut' | 'paste' | 'duplicate' | null {
  if (key === 'a' && last === 'arena') return 'selectAll';
  if (key === 'v' && !editor.clipboard.isEmpty && (hasSelection(editor) || last === 'arena')) return 'paste';
  if (!hasSelection(editor)) return null;
  if (key === 'd') return 'duplicate';
  if (getSelection()?.isCollapsed === false) return null; // text selected on the page is what gets copied
  return key === 'c' ? 'copy' : key === 'x' ? 'cut' : null;
}

type Place = 'arena' | 'console' | null;

/** Where the user last clicked or moved the focus to; the page's bar does not count. */
function useLastPlace(): Readonly<ShallowRef<Place>> {
  const last = shallowRef<Place>(null);
  function use({ target }: Event): void {
    const pane = target instanceof Element ? target.closest('.pane, [data-editor-keys]') : null;
    if (pane === null) return;
    const isArena = pane.matches('.pane-arena, [data-editor-keys]');
    last.value = isArena ? 'arena' : pane.matches('.pane-console') ? 'console' : null;
  }
  addEventListener('pointerdown', use, true);
  addEventListener('focusin', use, true);
  onScopeDispose(() => {
    removeEventListener('pointerdown', use, true);
    removeEventListener('focusin', use, true);
  });
  return last;
}

/** Text fields, the code, open menus and dialogs have keys of their own; in the editor's windows undo still works. */
function takesKeys(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('input, textarea, select, [contenteditable="true"], [role="menu"], [role="listbox"]') !== null)
    return true;
  return target.closest('[role="dialog"]') !== null && target.closest('[data-editor-window]') === null;
}
