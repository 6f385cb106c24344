import { onBeforeUnmount, shallowRef, watch, type ShallowRef } from 'vue';

import type { Box } from './place-bubble';

/** The target of a step: the selector that was visible, the element, and its place. */
export interface Target {
  readonly selector: string;
  readonly element: HTMLElement;
  readonly box: Box;
}

/**
 * Interval at which the place is checked, in ms: sliding and unfolding fire no event. Chosen: soon enough for the eye.
 */
const LOOK_MS = 150;

/**
 * Follows a control on the page: the first selector that matches something in sight; `null` while there is
 * nothing. It follows when the window, the control or the page changes.
 */
export function useTarget(selectors: () => readonly string[]): Readonly<ShallowRef<Target | null>> {
  const target = shallowRef<Target | null>(null);
  function look(): void {
    const found = find(selectors());
    if (!isSame(found, target.value)) target.value = found;
  }
  const timer = setInterval(look, LOOK_MS);
  addEventListener('resize', look);
  addEventListener('scroll', look, { capture: true, passive: true });
  onBeforeUnmount(() => {
    clearInterval(timer);
    removeEventListener('resize', look);
    removeEventListener('scroll', look, { capture: true });
  });
  watch(selectors, look, { immediate: true, flush: 'post' });
  return target;
}

function find(selectors: readonly string[]): Target | null {
  for (const selector of selectors) {
    for (const element of document.querySelectorAll<HTMLElement>(selector)) {
      const { left, top, width, height } = element.getBoundingClientRect();
      if (width > 0 && height > 0) return { selector, element, box: { left, top, width, height } };
    }
  }
  return null;
}

const isSame = (one: Target | null, other: Target | null): boolean =>
  one?.element === other?.element &&
  one?.box.left === other?.box.left &&
  one?.box.top === other?.box.top &&
  one?.box.width === other?.box.width &&
  one?.box.height === other?.box.height;
