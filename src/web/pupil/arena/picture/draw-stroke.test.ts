import { describe, expect, it } from 'vitest';
import { pathStep, thinned } from './draw-stroke';

describe('a line on the canvas', () => {
  it('leaves out points that would fall together, and keeps both ends', () => {
    const points = Array.from({ length: 101 }, (_, i) => [i, 0] as const);
    const kept = thinned(points, 10);
    expect(kept).toHaveLength(11);
    expect([kept[0], kept.at(-1)]).toEqual([
      [0, 0],
      [100, 0],
    ]);
    expect(thinned([[5, 5], [6, 5]], 10)).toHaveLength(2); // prettier-ignore
  });

  it('is made ready anew when the zoom has doubled, not before', () => {
    expect(pathStep(0.9)).toBe(pathStep(0.6));
    expect(pathStep(1.8)).toBe(pathStep(0.9) + 1);
  });
});
