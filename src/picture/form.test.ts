import { describe, expect, it } from 'vitest';

import { stripes } from './form';

describe('diagonal stripes', () => {
  it('end at the edges of their box and are as wide as wanted', () => {
    const shape = stripes({ sizeMm: { x: 100, y: 40 } }, { first: -65, pitch: 14, width: 4 });
    const all = shape.form === 'lines' ? shape.lines : [];
    expect(all.length).toBeGreaterThan(9);
    for (const [x, y] of all.flat()) {
      expect(Math.abs(x)).toBeLessThanOrEqual(50 + 1e-9);
      expect(Math.abs(y)).toBeLessThanOrEqual(20 + 1e-9);
    }
    const sums = all[4]!.map(([x, y]) => x + y);
    expect(Math.max(...sums) - Math.min(...sums)).toBeCloseTo(4 * Math.SQRT2);
  });
});
