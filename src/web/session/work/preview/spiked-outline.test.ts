import { describe, expect, it } from 'vitest';

import { spikedOutline } from './spiked-outline';

const pointsOf = (text: string): number[][] => text.split(' ').map((point) => point.split(',').map(Number));

describe('the outline of spikes on a small picture', () => {
  it('stays in its box, and its tips reach every side of it', () => {
    for (const size of [
      [900, 40],
      [50, 200],
      [30, 30],
    ] as const) {
      const points = pointsOf(spikedOutline({ size }));
      const [x, y] = [size[0] / 2, size[1] / 2];
      expect(Math.max(...points.map((point) => point[0]!))).toBe(x);
      expect(Math.min(...points.map((point) => point[0]!))).toBe(-x);
      expect(Math.max(...points.map((point) => point[1]!))).toBe(y);
      expect(Math.min(...points.map((point) => point[1]!))).toBe(-y);
    }
  });

  it('has more teeth on longer sides: 26 on each long side of a bar of 900 mm', () => {
    const tips = pointsOf(spikedOutline({ size: [900, 40] })).filter((point) => point[1] === 20);
    expect(tips).toHaveLength(26);
  });
});
