import { onScopeDispose } from 'vue';

import type { RunParts } from '../../session/run/parts';
import { pressBoard } from './drawing/board-press';
import { Presses, type BoardKey } from './drawing/presses';

/** Keys of the keyboard that press something on the board. */
const BOARD_KEYS: Readonly<Record<string, BoardKey>> = { a: 'a', b: 'b', l: 'pinLogo' };

/** Listens to the page's keys: a, b and l press the board during a run, while no text is being written. */
export function useBoardKeys({ run }: Pick<RunParts, 'run'>): void {
  const presses = new Presses({
    press: (key) => pressBoard(run, key, true),
    release: (key) => pressBoard(run, key, false),
  });
  function down(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return;
    const key = BOARD_KEYS[event.key.toLowerCase()];
    if (key === undefined || takesText(event.target) || !run.isActive.value) return;
    presses.hold(key, [key]);
  }
  function up(event: KeyboardEvent): void {
    const key = BOARD_KEYS[event.key.toLowerCase()];
    if (key !== undefined) presses.letGo(key);
  }
  const releaseAll = (): void => presses.letGoAll();
  addEventListener('keydown', down);
  addEventListener('keyup', up);
  addEventListener('blur', releaseAll);
  onScopeDispose(() => {
    removeEventListener('keydown', down);
    removeEventListener('keyup', up);
    removeEventListener('blur', releaseAll);
    presses.letGoAll();
  });
}

/** True if letters belong to the element: to text fields, and to menus, which jump to an entry by its first letter. */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  return (
    target.closest(
      'input, textarea, select, [contenteditable="true"], [role="menu"], [role="listbox"], [role="dialog"]',
    ) !== null
  );
}
