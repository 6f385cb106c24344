import { onBeforeUnmount, shallowRef, watch, type Ref } from 'vue';

import type { Size } from '../overlays/place-menu';

/** The size of an element in px; 0 × 0 until it is there. */
export function useSize(element: Readonly<Ref<HTMLElement | null>>): Readonly<Ref<Size>> {
  const size = shallowRef<Size>({ width: 0, height: 0 });
  const observer = new ResizeObserver(([entry]) => {
    if (entry === undefined) return;
    const { width, height } = entry.contentRect;
    size.value = { width, height };
  });
  watch(element, (now) => {
    observer.disconnect();
    if (now !== null) observer.observe(now);
  }, { immediate: true }); // prettier-ignore
  onBeforeUnmount(() => observer.disconnect());
  return size;
}
