/** Less than this the keyboard cannot cover: a browser's own bars come and go, too. Chosen, in px. */
const LEAST_PX = 120;

/**
 * Whether the soft keyboard is up, by how much of the window is left to see. `null` while it is unknown: no keyboard
 * was seen at this width, as with one on a cable or one that floats.
 */
export interface SoftKeyboard {
  /** Takes the visible size of the page now, in px. */
  see(width: number, height: number): void;
  readonly isUp: boolean | null;
}

export function createSoftKeyboard(): SoftKeyboard {
  let width = 0;
  let highest = 0;
  let isUp: boolean | null = null;
  return {
    see(seenWidth, height) {
      // Held the other way round, it may be up already.
      if (seenWidth !== width) [width, highest, isUp] = [seenWidth, height, null];
      highest = Math.max(highest, height);
      if (highest - height >= LEAST_PX) isUp = true;
      else if (isUp === true) isUp = false;
    },
    get isUp() {
      return isUp;
    },
  };
}
