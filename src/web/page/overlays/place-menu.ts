/** Where a menu lies when there is room: below or above its button, in line with its left (`start`) or right edge. */
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
/** With less room, in px, a menu covers its button. Chosen: five entries. */
const LEAST = 240;

/** In line with the wanted edge of the button, with the other one if only that leaves it in the window. */
function leftOf(at: ButtonBox, width: number, view: Size, align: 'start' | 'end'): number {
  const last = view.width - MARGIN - width;
  const lefts = align === 'end' ? [at.right - width, at.left] : [at.left, at.right - width];
  const fitting = lefts.find((left) => left >= MARGIN && left <= last);
  return fitting ?? Math.max(MARGIN, Math.min(lefts[0] ?? MARGIN, last));
}

/**
 * Places a menu at its button: on the other side where it has more room there and needs it, and always in the window.
 * In a window that is low it may cover the button.
 *
 * @param menu its size if nothing limits its height
 */
export function placeMenu(at: ButtonBox, menu: Size, view: Size, location: MenuLocation): MenuPlace {
  const [wanted, align] = location.split(' ');
  const below = view.height - MARGIN - at.bottom - GAP;
  const above = at.top - GAP - MARGIN;
  const [room, other] = wanted === 'top' ? [above, below] : [below, above];
  const isFlipped = menu.height > room && other > room;
  const maxHeight = Math.max(0, isFlipped ? other : room);
  const height = Math.min(menu.height, maxHeight);
  const isAbove = (wanted === 'top') !== isFlipped;
  const left = leftOf(at, menu.width, view, align === 'end' ? 'end' : 'start');
  if (height < Math.min(menu.height, LEAST)) {
    const whole = view.height - 2 * MARGIN;
    const last = view.height - MARGIN - Math.min(menu.height, whole);
    return { left, top: Math.max(MARGIN, Math.min(at.bottom + GAP, last)), maxHeight: whole };
  }
  return {
    left,
    top: isAbove ? at.top - GAP - height : at.bottom + GAP,
    maxHeight,
  };
}
