import { onScopeDispose } from 'vue';

import { ARENA_MODES, type ArenaMode } from './mode-model';
import type { ModeParts } from './parts';

/** The keys that enter a mode, as they are shown. */
export const keysOfMode = (mode: ArenaMode): readonly string[] => ['Alt', String(ARENA_MODES.indexOf(mode) + 1)];

/** Alt with 1, 2 and 3 enters a mode from anywhere on the page. */
export function useModeKeys({ mode }: ModeParts): void {
  function down(event: KeyboardEvent): void {
    if (!event.altKey || event.repeat || event.ctrlKey || event.metaKey || event.shiftKey) return;
    // By its place: on a Mac Alt makes another sign of the figure.
    const wished = ARENA_MODES[Number(/^(?:Digit|Numpad)([1-9])$/.exec(event.code)?.[1] ?? NaN) - 1];
    if (wished === undefined) return;
    mode.enter(wished);
    event.preventDefault();
  }
  addEventListener('keydown', down);
  onScopeDispose(() => removeEventListener('keydown', down));
}
