/**
 * Place of a menu if there is room: below or above its button, aligned with its left edge, or at its `end` the right
 * one.
 */
export type MenuLocation = `${'bottom' | 'top'}${'' | ' start' | ' end'}`;

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A button's place in the window, in px. */
export interface ButtonBox {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** A menu's place in the window, in px. What is longer scrolls. */
export interface MenuPlace {
  readonly left: number;
  readonly top: number;
  readonly maxHeight: number;
}

/** Distance from the button, and the least one from the edges of the window, in px. Chosen. */
const GAP = 6;
const MARGIN = 12;

/** In line with the wanted edge of the button, with the other one if only that leaves it in the window. */
function leftOf(at: ButtonBox, width: number, view: Size, isAtEnd: boolean): number {
  const last = view.width - MARGIN - width;
  const lefts = isAtEnd ? [at.right - width, at.left] : [at.left, at.right - width];
  const fitting = lefts.find((left) => left >= MARGIN && left <= last);
  return fitting ?? Math.max(MARGIN, Math.min(lefts[0] ?? MARGIN, last));
}

/**
 * Places a menu at its button: on the other side where it has not enough room, and over the button where neither side has.
 * It is always in the window.
 *
 * @param menu its size if nothing limits its height
 */
export function placeMenu(at: ButtonBox, menu: Size, view: Size, location: MenuLocation): MenuPlace {
  const maxHeight = view.height - 2 * MARGIN;
  const height = Math.min(menu.height, maxHeight);
  const below = at.bottom + GAP;
  const above = at.top - GAP - height;
  const fitsBelow = below + height <= view.height - MARGIN;
  const fitsAbove = above >= MARGIN;
  const isAbove = location.startsWith('top') ? fitsAbove || !fitsBelow : fitsAbove && !fitsBelow;
  return {
    left: leftOf(at, menu.width, view, location.endsWith('end')),
    top: Math.max(MARGIN, Math.min(isAbove ? above : below, view.height - MARGIN - height)),
    maxHeight,
  };
}
