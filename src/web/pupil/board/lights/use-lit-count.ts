import { onBeforeUnmount, shallowRef, watch, type ShallowRef } from 'vue';

import { litCount } from './light-form';

/** How often the number changes at most, in ms: a screen reader must be able to finish a sentence. */
const RENEW_MS = 1000;

/** How many lights are on, counted at most once a second. */
export function useLitCount(colors: () => readonly (readonly number[])[]): Readonly<ShallowRef<number>> {
  const lit = shallowRef(litCount(colors()));
  let timer: ReturnType<typeof setTimeout> | null = null;
  const count = (): void => {
    timer = null;
    lit.value = litCount(colors());
  };
  watch(colors, () => (timer ??= setTimeout(count, RENEW_MS)));
  onBeforeUnmount(() => {
    if (timer !== null) clearTimeout(timer);
  });
  return lit;
}
