import { nextTick, onMounted, onScopeDispose, watch, type ShallowRef } from 'vue';

/**
 * Who chooses the tool for words with the mouse, or has just put words down with it, types next: the field gets the
 * focus, so that letters are words and not the keys of tools. Fingers see no keyboard that they did not ask for, and
 * who works with keys keeps the focus where it is.
 *
 * @param count how many labels there are
 */
export function useTypedNext(field: Readonly<ShallowRef<HTMLInputElement | null>>, count: () => number): void {
  /** The last thing done was to let go of a mouse in the arena. */
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
