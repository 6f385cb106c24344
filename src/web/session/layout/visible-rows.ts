/** The rows of a long table that have to be drawn: `from` up to, not including, `until`, and the space for the others. */
export interface VisibleRows {
  readonly from: number;
  readonly until: number;
  readonly abovePx: number;
  readonly belowPx: number;
}

/** Rows drawn beyond the edges, so that quick scrolling shows no gaps. */
const MARGIN = 8;

/** Finds them from the position of the scroll bar. All rows have the same height. */
export function visibleRows(count: number, rowPx: number, scrollPx: number, heightPx: number): VisibleRows {
  const first = Math.max(0, Math.min(count, Math.floor(scrollPx / rowPx) - MARGIN));
  const last = Math.max(first, Math.min(count, Math.ceil((scrollPx + heightPx) / rowPx) + MARGIN));
  return { from: first, until: last, abovePx: first * rowPx, belowPx: (count - last) * rowPx };
}
