import { computed, onBeforeUnmount, onMounted, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { createSoftKeyboard } from './soft-keyboard';

/** When the keys over the soft keyboard are shown, and how much of the editor the keyboard covers. */
export interface KeyRowState {
  readonly isShown: ComputedRef<boolean>;
  /** In px; 0 where the browser makes the page smaller instead. */
  readonly covered: Readonly<ShallowRef<number>>;
}

/**
 * The keys are there while a finger's cursor is in the editor and the keyboard is up, or while it is unknown whether it
 * is: never with a mouse.
 *
 * @param box the editor and the row of keys
 */
export function useKeyRow(box: Readonly<ShallowRef<HTMLElement | null>>): KeyRowState {
  const coarse = matchMedia('(pointer: coarse)');
  const isTouch = shallowRef(coarse.matches);
  const hasFocus = shallowRef(false);
  const isUp = shallowRef<boolean | null>(null);
  const covered = shallowRef(0);
  const keyboard = createSoftKeyboard();

  const measure = (): void => {
    const seen = window.visualViewport;
    if (seen === null) return;
    keyboard.see(Math.round(seen.width * seen.scale), Math.round(seen.height * seen.scale));
    isUp.value = keyboard.isUp;
    const bottom = box.value?.getBoundingClientRect().bottom ?? 0;
    // Who has zoomed in looks at a part of the page; the keyboard is not what hides the rest.
    const isAway = !hasFocus.value || isUp.value !== true || seen.scale > 1.01;
    covered.value = isAway ? 0 : Math.max(0, Math.round(bottom - seen.offsetTop - seen.height));
  };
  const followPointer = (): void => void (isTouch.value = coarse.matches);
  const followFocus = ({ type, relatedTarget }: FocusEvent): void => {
    hasFocus.value =
      type === 'focusin' || (relatedTarget instanceof Node && box.value?.contains(relatedTarget) === true);
    measure();
  };

  onMounted(() => {
    measure();
    coarse.addEventListener('change', followPointer);
    for (const name of ['focusin', 'focusout'] as const) box.value?.addEventListener(name, followFocus);
    for (const name of ['resize', 'scroll']) window.visualViewport?.addEventListener(name, measure);
  });
  onBeforeUnmount(() => {
    coarse.removeEventListener('change', followPointer);
    for (const name of ['resize', 'scroll']) window.visualViewport?.removeEventListener(name, measure);
  });
  return { isShown: computed(() => isTouch.value && hasFocus.value && isUp.value !== false), covered };
}
