/** A rectangle in the window, in px. */
export interface ShelfBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The least room beside or above the arena that is enough for the shelf, in px: two columns, or two rows of parts. */
const LEAST = { width: 260, height: 200 } as const;
/** The largest width of the shelf beside the arena, in px: beyond it there would only be larger gaps. */
const MOST_WIDTH = 420;
const GAP = 8;
/** Share of the window's height that it covers where there is no room beside the arena, which stays in sight above. */
const SHEET_SHARE = 0.42;

/**
 * Place of the shelf: at the left of the arena, or above it, over what is written and read; on a phone, and where the
 * arena is alone, over its lower part.
 *
 * @param arena the pane of the arena
 * @param panes the part of the window that holds all panes
 */
export function shelfPlace(arena: ShelfBox, panes: ShelfBox): ShelfBox {
  const beside = arena.left - panes.left - GAP;
  if (beside >= LEAST.width)
    return { left: panes.left, top: arena.top, width: Math.min(MOST_WIDTH, beside), height: arena.height };
  const above = arena.top - panes.top - GAP;
  if (above >= LEAST.height) return { left: panes.left, top: panes.top, width: panes.width, height: above };
  const height = Math.round(SHEET_SHARE * (panes.top + panes.height));
  const width = Math.min(panes.width, Math.max(MOST_WIDTH, arena.width / 2));
  return { left: panes.left, top: panes.top + panes.height - height, width, height };
}
