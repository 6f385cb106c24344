import { onScopeDispose } from 'vue';

import type { App } from './use-app';
import type { BoardKey } from '../board/presses';

/** Keys of the keyboard that press something on the board. */
const BOARD_KEYS: Readonly<Record<string, BoardKey>> = { a: 'a', b: 'b', l: 'pinLogo' };

/** What keys on the whole page do. */
export interface KeyActions {
  press(key: BoardKey, down: boolean): void;
  run(): void;
  save(): void;
}

/** Listens to the page's keys: a, b and l press the board while no text is being written; Ctrl+Enter runs, Ctrl+S saves. */
export function useKeys({ run }: Pick<App, 'run'>, actions: KeyActions): void {
  const held = new Set<BoardKey>();
  function down(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return command(event, actions);
    const key = BOARD_KEYS[event.key.toLowerCase()];
    if (key === undefined || event.altKey || event.repeat || takesText(event.target) || !run.isActive.value) return;
    held.add(key);
    actions.press(key, true);
  }
  function up(event: KeyboardEvent): void {
    const key = BOARD_KEYS[event.key.toLowerCase()];
    if (key !== undefined && held.delete(key)) actions.press(key, false);
  }
  function releaseAll(): void {
    for (const key of held) actions.press(key, false);
    held.clear();
  }
  addEventListener('keydown', down);
  addEventListener('keyup', up);
  addEventListener('blur', releaseAll);
  onScopeDispose(() => {
    removeEventListener('keydown', down);
    removeEventListener('keyup', up);
    removeEventListener('blur', releaseAll);
  });
}

function command(event: KeyboardEvent, actions: KeyActions): void {
  if (event.altKey || event.shiftKey || event.repeat) return;
  if (event.key === 'Enter') actions.run();
  else if (event.key === 's') actions.save();
  else return;
  event.preventDefault();
}

/** Letters belong to text fields, and to menus, which jump to an entry by its first letter. */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  return (
    target.closest(
      'input, textarea, select, [contenteditable="true"], [role="menu"], [role="listbox"], [role="dialog"]',
    ) !== null
  );
}
