import { describe, expect, it } from 'vitest';

import { visibleRows } from './visible-rows';

describe('a long table', () => {
  it('draws 26 of 40 000 rows in 280 px, somewhere in the middle', () => {
    const rows = visibleRows(40_000, 28, 28 * 20_000, 280);
    expect(rows).toEqual({ from: 19_992, until: 20_018, abovePx: 28 * 19_992, belowPx: 28 * 19_982 });
  });

  it('draws everything of a short one', () => {
    expect(visibleRows(3, 28, 0, 280)).toEqual({ from: 0, until: 3, abovePx: 0, belowPx: 0 });
  });

  it('stays within the table when the scroll bar is beyond its end', () => {
    expect(visibleRows(10, 28, 5000, 280)).toEqual({ from: 10, until: 10, abovePx: 280, belowPx: 0 });
    expect(visibleRows(0, 28, 0, 280)).toEqual({ from: 0, until: 0, abovePx: 0, belowPx: 0 });
  });
});
