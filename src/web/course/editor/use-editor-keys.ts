import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';

import type { RunParts } from '../../session/run/parts';
import type { PasteParts } from './paste-given';
import type { CourseEditorParts } from './state/parts';
import { toolOfLetter } from './palette/tool-list';
import type { SelectionActs } from './state/selection-acts';
import { useClipboard } from './use-clipboard';

/** Letters that press buttons of the board while a program runs. */
const BOARD_LETTERS = ['a', 'b', 'l'];

/**
 * The editor's keyboard shortcuts. Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z work on the whole page except in text fields;
 * letters choose tools while the arena, the palette or the head has the focus; R turns what is selected, if anything is. While a program runs and the hand is
 * chosen, A, B and L belong to the board. In the arena the drawing surface handles the other keys for the selection;
 * elsewhere on the page Delete, Escape, the arrows and Ctrl with D, G and A are handled here, as long as the selection is visible,
 * and those of the clipboard for the whole page.
 */
export function useEditorKeys(app: Pick<RunParts, 'run'> & PasteParts): void {
  const { editor, run } = app;
  const last = useLastPlace();
  const acts = useLateActs(app);

  function letter(key: string): boolean {
    if (run.isActive.value && editor.tool.value === 'hand' && BOARD_LETTERS.includes(key)) return false;
    const tool = toolOfLetter(key);
    if (tool === undefined) return false;
    if (tool === 'rotate' && hasAny(editor)) acts.use(({ turn }) => turn(-1));
    else editor.choose(tool);
    return true;
  }

  const pastes = (target: EventTarget | null): boolean =>
    editor.isOpen.value &&
    !takesKeys(target) &&
    (last.value === 'arena' || (hasSelection(editor) && last.value !== 'console'));
  const clipboard = useClipboard({ app, withActs: acts.use, pastes });

  /** The browser's own events for the clipboard follow the key: it is not kept from them. */
  function clipboardKey(key: string, target: EventTarget | null): void {
    if (key === 'v' && pastes(target)) clipboard.paste();
    else if ((key === 'c' || key === 'x') && copies(editor)) clipboard.copy(key === 'x');
  }

  function besideArena(event: KeyboardEvent, key: string, control: boolean): boolean {
    if (!control && isArrow(key)) return toArena(event, editor);
    if (!control && key === 'escape') return last.value === 'arena' && letsGo(event, editor);
    // While all is still being selected, it counts as selected: what follows waits for it.
    const isSelected = hasSelection(editor) || acts.areComing();
    const act = control ? commandOf(key, event.shiftKey, isSelected, last.value) : removes(key, isSelected);
    if (act === null) return false;
    acts.use((loaded) => loaded[act]());
    return true;
  }

  function down(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.altKey || takesKeys(event.target)) return;
    const place = event.target instanceof Element ? event.target.closest('[data-editor-keys]') : null;
    const key = event.key.toLowerCase();
    const control = event.ctrlKey || event.metaKey;
    const isInArena = event.target instanceof Element && event.target.closest('[role="application"]') !== null;
    const isForSelection = editor.isOpen.value && last.value !== 'console';
    if (isForSelection && control && !event.shiftKey) clipboardKey(key, event.target);
    const done =
      (control && undoes(key, event.shiftKey, editor)) ||
      (isForSelection &&
        !isInArena &&
        (!event.shiftKey || isArrow(key) || key === 'g') &&
        besideArena(event, key, control)) ||
      (editor.isOpen.value && place !== null && !control && !event.shiftKey && !event.repeat && letter(key));
    if (!done) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  addEventListener('keydown', down, true);
  onScopeDispose(() => removeEventListener('keydown', down, true));
}

/** Ctrl with Z and Y. @returns whether the key was one of them */
function undoes(key: string, shift: boolean, editor: Editor): boolean {
  if (key === 'z' && shift) editor.redo();
  else if (key === 'z') editor.undo();
  else if (key === 'y' && !shift) editor.redo();
  else return false;
  return true;
}

/** The actions for a selection. */
interface LateActs {
  /** At once, or as soon as they are there, in the order of the calls. */
  readonly use: (act: (acts: SelectionActs) => void) => void;
  /** True if something waits for them. */
  readonly areComing: () => boolean;
}

/** Loads the actions with the first selection, so that the browser's clipboard waits for nothing. */
function useLateActs(app: PasteParts): LateActs {
  let loaded: SelectionActs | null = null;
  let waiting = 0;
  const load = async (): Promise<SelectionActs> => {
    const { useSelectionActs: make } = await import('./state/use-selection-acts');
    return (loaded ??= make(app));
  };
  function use(act: (acts: SelectionActs) => void): void {
    if (loaded !== null) return act(loaded);
    waiting += 1;
    load()
      .then(act, () => undefined) // offline, nothing happens
      .finally(() => (waiting -= 1));
  }
  watch(
    () => hasSelection(app.editor),
    (isSelected) => isSelected && void load().catch(() => undefined),
  );
  return { use, areComing: () => waiting > 0 };
}

type Editor = CourseEditorParts['editor'];
const hasAny = (editor: Editor): boolean => hasSelection(editor) || editor.selection.value.robot;
const hasSelection = ({ selection }: Editor): boolean => selection.value.ids.length > 0;
const removes = (key: string, isSelected: boolean): 'remove' | null =>
  isSelected && (key === 'delete' || key === 'backspace') ? 'remove' : null;

/** True if a copy is of the selection in the arena, because no text is selected on the page. */
const copies = (editor: Editor): boolean => hasSelection(editor) && getSelection()?.isCollapsed !== false;

/** The act of a key pressed with Ctrl, besides the clipboard; `null` leaves it to the browser. */
function commandOf(
  key: string,
  shift: boolean,
  isSelected: boolean,
  last: Place,
): 'selectAll' | 'duplicate' | 'group' | 'ungroup' | null {
  if (key === 'g' && isSelected) return shift ? 'ungroup' : 'group';
  if (key === 'a' && last === 'arena') return 'selectAll';
  return key === 'd' && isSelected ? 'duplicate' : null;
}

/** Elements that Escape closes, and the lists of the editor's windows, where it is no key of the arena. */
const ESCAPE_USERS = '[role="dialog"], [data-testid="guide"], [aria-expanded="true"]';

/** Deselects everything, for Escape. @returns whether something was selected, and the key was meant for it */
function letsGo({ target }: Event, editor: Editor): boolean {
  if (!hasAny(editor)) return false;
  const isOthers = target instanceof Element && target.closest(ESCAPE_USERS) !== null;
  if (isOthers || document.querySelector('.page-overlay--active') !== null) return false;
  editor.select({ ids: [], robot: false });
  return true;
}

const isArrow = (key: string): boolean => key.startsWith('arrow');

/** Elements that the arrow keys move in, or scroll. */
const ARROW_USERS =
  '[role="radiogroup"], [role="slider"], [role="tablist"], [role="toolbar"], [role="separator"], [role="dialog"], [aria-haspopup]';

/**
 * Leads an arrow key to what is visibly selected in the arena, which gets the keyboard: all arrows until they are let go are
 * one step there.
 */
function toArena(event: KeyboardEvent, editor: Editor): boolean {
  const arena = document.querySelector<HTMLElement>('.pane-arena [role="application"]');
  if (!hasAny(editor) || arena === null) return false;
  if (event.target instanceof Element && event.target.closest(ARROW_USERS) !== null) return false;
  arena.focus({ preventScroll: true });
  const { key, shiftKey } = event;
  return !arena.dispatchEvent(new KeyboardEvent('keydown', { key, shiftKey, bubbles: true, cancelable: true }));
}

type Place = 'arena' | 'console' | null;

/** The last place that the user clicked or moved the focus to; the page's bar does not count. */
function useLastPlace(): Readonly<ShallowRef<Place>> {
  const last = shallowRef<Place>('arena'); // building has just begun
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

/** True for what has keys of its own: text fields, the code, open menus, and dialogs but for the editor's windows. */
function takesKeys(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('input, textarea, select, [contenteditable="true"], [role="menu"], [role="listbox"]') !== null)
    return true;
  return target.closest('[role="dialog"]') !== null && target.closest('[data-editor-window]') === null;
}
