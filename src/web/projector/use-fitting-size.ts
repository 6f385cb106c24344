import { onBeforeUnmount, onMounted, watch, type ShallowRef } from 'vue';

import { fittingSize, sizeLimits } from './fitting-size';

type Found = Readonly<ShallowRef<HTMLElement | null>>;

/**
 * Makes the letters of a place as large as its parts still fit, and keeps them so.
 *
 * @param host gets the size as `--size`
 * @param parts scroll where even the least size is too large
 * @param changes what the room depends on besides the window
 */
export function useFittingSize(host: Found, parts: readonly Found[], changes: () => unknown): void {
  function fits(px: number): boolean {
    host.value?.style.setProperty('--size', `${String(px)}px`);
    return parts.every(({ value: part }) => {
      if (part === null) return true;
      return part.scrollHeight <= part.clientHeight + 1 && part.scrollWidth <= part.clientWidth + 1;
    });
  }
  function fit(): void {
    if (host.value === null) return;
    fits(fittingSize(sizeLimits(innerWidth, innerHeight), fits));
  }
  const observer = new ResizeObserver(fit);
  watch(changes, fit, { flush: 'post' });
  onMounted(() => {
    // The host has its size from the window; what is in the parts may come later, such as a picture.
    if (host.value !== null) observer.observe(host.value);
    for (const { value: part } of parts) for (const child of part?.children ?? []) observer.observe(child);
    fit();
  });
  onBeforeUnmount(() => observer.disconnect());
}
