import { nextTick, onMounted, onScopeDispose, watch, type ShallowRef } from 'vue';

/**
 * Someone who picks the text tool with the mouse, or has just placed a text with it, will type next: the field gets the
 * focus, so that letters become text instead of choosing tools. Not after a touch, which would bring up the on-screen
 * keyboard unasked; and those who work with the keyboard keep their focus.
 *
 * @param count how many labels there are
 */
export function useTypedNext(field: Readonly<ShallowRef<HTMLInputElement | null>>, count: () => number): void {
  /** The last thing the user did was to release the mouse button in the arena. */
  let isPlacing = false;
  const listeners = {
    pointerup: ({ pointerType, target }: PointerEvent) => {
      isPlacing =
        pointerType === 'mouse' && target instanceof Element && target.closest('[role="application"]') !== null;
    },
    keydown: () => {
      isPlacing = false;
    },
  };
  const entries = Object.entries(listeners) as [string, EventListener][];
  for (const [type, listener] of entries) addEventListener(type, listener, true);
  onScopeDispose(() => {
    for (const [type, listener] of entries) removeEventListener(type, listener, true);
  });

  function invite(): void {
    field.value?.focus({ preventScroll: true });
    field.value?.select();
  }
  onMounted(() => {
    const pressed = document.activeElement;
    const isMouse = matchMedia('(pointer: fine)').matches && pressed?.matches(':focus-visible') === false;
    if (isMouse && pressed.matches('[data-tool="label"]')) invite();
  });
  watch(count, (now, before) => {
    if (now > before && isPlacing) void nextTick(invite);
  });
}
