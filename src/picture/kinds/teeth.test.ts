import { describe, expect, it } from 'vitest';
import { teeth } from './teeth';

describe('the teeth of spikes', () => {
  const points = teeth({ sizeMm: { x: 60, y: 40 } });

  it('reach to the edge of what a robot bumps into on all sides, and nowhere beyond', () => {
    const xs = points.map(({ x }) => x);
    const ys = points.map(({ y }) => y);
    expect([Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]).toEqual([-30, 30, -20, 20]);
  });

  it('are as many on opposite sides', () => {
    const tips = (is: (point: { x: number; y: number }) => boolean): number => points.filter(is).length;
    expect(tips(({ x }) => x === -30)).toBe(tips(({ x }) => x === 30));
    expect(tips(({ y }) => y === -20)).toBe(tips(({ y }) => y === 20));
    expect(tips(({ y }) => y === 20)).toBeGreaterThan(3);
  });
});
