import { describe, expect, it } from 'vitest';
import { Trail } from './trail';
import { Trails } from './trails';

const points = (trail: Trail): number[] => [...trail.xyMm.subarray(0, 2 * trail.count)];

describe('the trail of a run', () => {
  it('keeps the points in the order in which they come, gaps included', () => {
    const trail = new Trail();
    trail.add([1, 2, 3, 4]);
    trail.add([NaN, NaN, 5, 6]);
    expect(points(trail)).toEqual([1, 2, 3, 4, NaN, NaN, 5, 6]);
    expect(trail.generation).toBe(0);
  });

  it('is empty after a reset, and says that what was drawn is gone', () => {
    const trail = new Trail();
    trail.add([1, 2]);
    trail.clear();
    expect([trail.count, trail.generation]).toEqual([0, 1]);
    trail.add([7, 8]);
    expect(points(trail)).toEqual([7, 8]);
  });

  it('never holds more than 65 536 points: 512 kB after 4 km', () => {
    const trail = new Trail();
    for (let i = 0; i < 1_000_000; i += 50)
      trail.add(Array.from({ length: 100 }, (_, part) => (part % 2 === 0 ? i + part / 2 : 0)));
    expect(trail.count).toBeLessThanOrEqual(65_536);
    expect(trail.xyMm.byteLength).toBeLessThanOrEqual(2 ** 19);
    expect(trail.xyMm[2 * trail.count - 2]).toBe(999_999);
    expect(trail.generation).toBeGreaterThan(0);
  });

  it('keeps the last points of a batch that is larger than itself', () => {
    const trail = new Trail();
    trail.add([1, 1]);
    trail.add(Array.from({ length: 400_000 }, (_, i) => i));
    expect(trail.count).toBeLessThanOrEqual(65_536);
    expect(trail.xyMm[2 * trail.count - 1]).toBe(399_999);
  });
});

describe('a trail that is looked back at', () => {
  it('goes as far as it went at that moment, and all of it once nobody looks back', () => {
    const trail = new Trail();
    trail.add([1, 1, 2, 2], 1000);
    trail.add([3, 3], 2000);
    trail.lookAt(1999);
    expect([points(trail), trail.generation]).toEqual([[1, 1, 2, 2], 1]);
    trail.lookAt(500);
    expect(points(trail)).toEqual([]);
    trail.lookAt(null);
    expect(points(trail)).toEqual([1, 1, 2, 2, 3, 3]);
  });
});

describe('the trails of several robots', () => {
  it('are kept apart, and all begin anew together, also if only the third has been looked at', () => {
    const trails = new Trails();
    trails.of(2).add([1, 2]);
    trails.add([[3, 4], [], [5, 6]], 0);
    expect([points(trails.first), points(trails.of(2))]).toEqual([[3, 4], [1, 2, 5, 6]]); // prettier-ignore
    trails.clear();
    expect([0, 1, 2].map((device) => trails.of(device).count)).toEqual([0, 0, 0]);
  });
});
