import { describe, expect, it } from 'vitest';
import { isHeap } from './overlaps';
import type { SceneObject } from './scene';

const blocks = (count: number, x: (index: number) => number, type: 'block' | 'fixed-block' = 'block'): SceneObject[] =>
  Array.from({ length: count }, (_, index) => ({
    ...{ type, id: `b${String(index)}`, size: [50, 50], angle: 0 },
    at: [x(index), 400],
  }));

describe('a heap of blocks', () => {
  it('is more than 2,000 pairs inside each other: 64 movable blocks at one place', () => {
    expect(isHeap(blocks(63, () => 500))).toBe(false);
    expect(isHeap(blocks(64, () => 500))).toBe(true);
    expect(isHeap(blocks(2_000, (index) => 500 + (index % 20)))).toBe(true);
  });

  it('is not what stands side by side, nor what cannot be pushed', () => {
    expect(isHeap(blocks(2_000, (index) => 50 * index))).toBe(false);
    expect(isHeap(blocks(2_000, () => 500, 'fixed-block'))).toBe(false);
  });
});
