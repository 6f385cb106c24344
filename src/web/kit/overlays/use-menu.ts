import { shallowRef, useTemplateRef, type ShallowRef } from 'vue';

/** A menu at a button. */
export interface Menu {
  readonly isOpen: ShallowRef<boolean>;
  /** Opens something in the menu's place; when that is left, the keyboard is where it was before. */
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
