import { onScopeDispose } from 'vue';

import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';
import type { CourseEditorParts } from './state/parts';
import { toolOfLetter } from './palette/tool-list';
import type { useSelectionActs } from './state/use-selection-acts';

/** Letters that press something on the board while a program runs. */
const BOARD_LETTERS = ['a', 'b', 'l'];

/**
 * Keys of the editor. Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z work on the whole page except in text fields; letters choose
 * tools while the arena, the palette or the head has the focus. While a program runs and the hand tool is chosen, A, B
 * and L belong to the board. In the arena itself the drawing surface has the other keys for what is selected; beside
 * it, where a button has just been pressed, the most common of them act here.
 */
export function useEditorKeys(app: Pick<RunParts, 'run'> & WorkParts & Pick<CourseEditorParts, 'editor'>): void {
  const { editor, run } = app;
  /** What acts on a selection is fetched with the first one. */
  function withActs(act: (acts: ReturnType<typeof useSelectionActs>) => void): void {
    import('./state/use-selection-acts').then(({ useSelectionActs: make }) => act(make(app))).catch(() => undefined); // without a connection nothing happens
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
    const hasSelection = editor.selection.value.ids.length > 0;
    if (control && key === 'a') withActs((acts) => acts.selectAll());
    else if (control && key === 'd' && hasSelection) withActs((acts) => acts.duplicate());
    else if (!control && (key === 'delete' || key === 'backspace') && hasSelection) withActs((acts) => acts.remove());
    else return false;
    return true;
  }

  function down(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.altKey || takesKeys(event.target)) return;
    const place = event.target instanceof Element ? event.target.closest('[data-editor-keys]') : null;
    const key = event.key.toLowerCase();
    const control = event.ctrlKey || event.metaKey;
    const isInArena = event.target instanceof Element && event.target.closest('[role="application"]') !== null;
    const acts = place !== null && editor.isOpen.value;
    const done =
      (control && withControl(key, event.shiftKey)) ||
      (acts && !isInArena && besideArena(key, control)) ||
      (acts && !control && !event.shiftKey && !event.repeat && letter(key));
    if (!done) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  addEventListener('keydown', down, true);
  onScopeDispose(() => removeEventListener('keydown', down, true));
}

/** Text fields, the code, and open menus and dialogs have keys of their own; in the editor's own windows undo goes on. */
function takesKeys(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('input, textarea, select, [contenteditable="true"], [role="menu"], [role="listbox"]') !== null)
    return true;
  return target.closest('[role="dialog"]') !== null && target.closest('[data-editor-window]') === null;
}
