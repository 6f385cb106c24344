import { nextTick, shallowRef, watch, type ShallowRef } from 'vue';

import type { LayoutParts } from '../../session/layout/parts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';

/** Elements in which people type, or that must be answered first. */
const WRITING = 'input, textarea, select, [contenteditable="true"], [role="dialog"], [role="menu"], [role="listbox"]';

/** The models that decide whether the field takes the keyboard. */
type Around = Pick<RunParts, 'run'> & Pick<WorkParts, 'work'> & Pick<LayoutParts, 'layout'>;

/**
 * Gives the keyboard to the console's field when the program waits in `input()`. Never in the middle of a word: whoever
 * has changed the program since it started goes on writing. A touch screen's keyboard would hide half of the page, so
 * there the field is only marked.
 */
export function useInputFocus({ run, work, layout }: Around, field: Readonly<ShallowRef<HTMLElement | null>>): void {
  const hasWritten = shallowRef(false);
  watch(work.files, () => (hasWritten.value = true));
  watch(run.phase, (phase) => {
    if (phase === 'starting') hasWritten.value = false;
  });
  watch(
    [run.isWaitingForInput, layout.isShown],
    async ([isWaiting]) => {
      if (!isWaiting || !mayFocus(hasWritten.value)) return;
      await nextTick(); // a pane that opens for it is there by then
      field.value?.focus();
    },
    { flush: 'post', immediate: true },
  );
}

function mayFocus(hasWritten: boolean): boolean {
  if (!document.hasFocus() || matchMedia('(pointer: coarse)').matches) return false;
  if (document.querySelector('[role="dialog"]') !== null) return false;
  const at = document.activeElement ?? document.body;
  return at.closest('.cm-editor') === null ? at.closest(WRITING) === null : !hasWritten;
}
