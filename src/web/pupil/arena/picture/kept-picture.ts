import { onBeforeUnmount } from 'vue';
import type { StillFrame } from './still-cache';

/** Shortest rest of the view before a cached picture is repainted sharp, in ms. */
const SETTLE_MS = 140;

/** Watches whether the view stands still. */
export interface ViewRest {
  /** Call it for each picture. Returns false from a change of the view until it has come to rest. */
  settled(frame: StillFrame): boolean;
  /** Requests a repaint of a picture that was not sharp, once the view has come to rest. */
  sharpenSoon(): void;
}

/** @param redraw called when the view has come to rest */
export function useViewRest(redraw: () => void): ViewRest {
  let isSettled = true;
  let before: object | null = null;
  let timer: ReturnType<typeof setTimeout> | null = null;
  const settle = (): void => {
    timer = null;
    isSettled = true;
    redraw();
  };
  onBeforeUnmount(() => {
    if (timer !== null) clearTimeout(timer);
  });
  return {
    settled(frame) {
      if (before !== null && before !== frame.view) isSettled = false;
      before = frame.view;
      return isSettled;
    },
    sharpenSoon() {
      if (timer !== null) clearTimeout(timer);
      timer = setTimeout(settle, SETTLE_MS);
    },
  };
}
