import { onBeforeUnmount, onMounted, type ShallowRef } from 'vue';

import { fittingSize, sizeLimits } from './fitting-size';

type Found = Readonly<ShallowRef<HTMLElement | null>>;

/**
 * Makes the letters of a place as large as its parts still fit, and keeps them so when the window changes, or what is in
 * the parts: also a picture that comes later.
 *
 * @param host gets the size as `--size`
 * @param parts scroll where even the least size is too large
 */
export function useFittingSize(host: Found, parts: readonly Found[]): void {
  function fits(px: number): boolean {
    host.value?.style.setProperty('--size', `${String(px)}px`);
    return parts.every(({ value: part }) => {
      if (part === null) return true;
      return part.scrollHeight <= part.clientHeight + 1 && part.scrollWidth <= part.clientWidth + 1;
    });
  }
  const fit = (): void => void fits(fittingSize(sizeLimits(innerWidth, innerHeight), fits));
  const sizes = new ResizeObserver(fit);
  const words = new MutationObserver(follow);
  function follow(): void {
    sizes.disconnect();
    if (host.value !== null) sizes.observe(host.value);
    for (const { value: part } of parts) for (const child of part?.children ?? []) sizes.observe(child);
    fit();
  }
  onMounted(() => {
    for (const { value: part } of parts)
      if (part !== null) words.observe(part, { childList: true, subtree: true, characterData: true });
    follow();
  });
  onBeforeUnmount(() => {
    sizes.disconnect();
    words.disconnect();
  });
}
