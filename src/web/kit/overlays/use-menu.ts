import { shallowRef, useTemplateRef, type ShallowRef } from 'vue';

/** A menu at a button. */
export interface Menu {
  readonly isOpen: ShallowRef<boolean>;
  /** Closes the menu, gives the keyboard back to its button, and opens something else. */
  leaveFor(open: () => void): void;
}

/** Makes a closed menu. Its button is the template ref `button`. */
export function useMenu(): Menu {
  const isOpen = shallowRef(false);
  const button = useTemplateRef<{ readonly $el: HTMLElement }>('button');
  return {
    isOpen,
    leaveFor(open) {
      isOpen.value = false;
      button.value?.$el.focus();
      open();
    },
  };
}
