import { nextTick, shallowRef, type Component, type ShallowRef } from 'vue';

import { lateView } from '../late-view';
import type { LoadedView } from '../loaded-view';

/** A place for one dialog at a time, which is loaded when it opens. Where it was opened gets the keyboard back. */
export function useLateDialog(): {
  /** The dialog that is open. */
  readonly dialog: Readonly<ShallowRef<Component | null>>;
  readonly open: (load: LoadedView) => void;
  readonly close: () => Promise<void>;
} {
  const dialog = shallowRef<Component | null>(null);
  let opener: Element | null = null;
  return {
    dialog,
    open(load) {
      opener = document.activeElement;
      dialog.value = lateView(load);
    },
    async close() {
      dialog.value = null;
      await nextTick();
      if (opener instanceof HTMLElement) opener.focus();
    },
  };
}
