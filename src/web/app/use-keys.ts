import { onScopeDispose } from 'vue';

import { Presses, type BoardKey } from '../pupil/board/drawing/presses';
import type { RunParts } from '../session/run/parts';

/** Keys of the keyboard that press something on the board. */
const BOARD_KEYS: Readonly<Record<string, BoardKey>> = { a: 'a', b: 'b', l: 'pinLogo' };

/** The actions of keys on the whole page. */
export interface KeyActions {
  press(key: BoardKey, down: boolean): void;
  run(): void;
  stop(): void;
  save(): void;
}

/**
 * Listens to the page's keys: a, b and l press the board during a run, while no text is being written; Ctrl+Enter runs,
 * Ctrl+Shift+Enter stops, Ctrl+S saves.
 */
export function useKeys({ run }: Pick<RunParts, 'run'>, actions: KeyActions): void {
  const presses = new Presses({
    press: (key) => actions.press(key, true),
    release: (key) => actions.press(key, false),
  });
  function down(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return command(event, actions);
    const key = BOARD_KEYS[event.key.toLowerCase()];
    if (key === undefined || event.altKey || event.repeat || takesText(event.target) || !run.isActive.value) return;
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

/** The properties of a key pressed together with Ctrl or ⌘. */
export type CommandKey = Pick<KeyboardEvent, 'key' | 'altKey' | 'shiftKey' | 'repeat' | 'preventDefault'>;

/** Does what a key means together with Ctrl or ⌘; the others stay the browser's. */
export function command(event: CommandKey, actions: Pick<KeyActions, 'run' | 'stop' | 'save'>): void {
  if (event.altKey || event.repeat) return;
  const key = event.key.toLowerCase(); // with Caps Lock it is an S
  if (key === 'enter' && event.shiftKey) actions.stop();
  else if (event.shiftKey) return;
  else if (key === 'enter') actions.run();
  else if (key === 's') actions.save();
  else return;
  event.preventDefault();
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
