import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import { describe, expect, it } from 'vitest';
import { squaredDistance } from './outline';
import type { Point } from './scene';
import { simplified } from './simplify';

const vec = ([x, y]: Point): Vec => ({ x, y });

/** How far the place of the drawing is from the nearest piece of the line. */
function distanceMm(place: Vec, line: readonly Point[]): number {
  const squares = line.map((point, index) => squaredDistance(place, vec(line[index - 1] ?? point), vec(point)));
  return Math.sqrt(Math.min(...squares));
}

/** A hand that scribbles: goes on, bends at random. */
function scribble(seed: number, places: number): Vec[] {
  const rng = createRng(seed);
  let [x, y, dx, dy] = [500, 400, 1, 0];
  return Array.from({ length: places }, () => {
    dx = 0.9 * dx + (rng.unit() - 0.5) * 3;
    dy = 0.9 * dy + (rng.unit() - 0.5) * 3;
    return { x: (x += dx), y: (y += dy) };
  });
}

describe('a drawn line', () => {
  it('becomes its two ends if it is straight, in whole mm', () => {
    const path = Array.from({ length: 500 }, (_, index) => ({ x: index * 0.7, y: index * 0.35 + 0.2 }));
    expect(simplified(path)).toEqual([
      [0, 0],
      [349, 175],
    ]);
  });

  it('keeps its corners', () => {
    const path = [0, 30, 60, 100].map((x) => ({ x, y: 0 })).concat([50, 100].map((y) => ({ x: 100, y })));
    expect(simplified(path)).toEqual([
      [0, 0],
      [100, 0],
      [100, 100],
    ]);
  });

  it('stays closed if it comes back to its start', () => {
    const circle = Array.from({ length: 201 }, (_, index) => {
      const angle = (2 * Math.PI * index) / 200;
      return { x: 300 + 100 * Math.cos(angle), y: 300 + 100 * Math.sin(angle) };
    });
    const points = simplified(circle);
    expect(points.at(-1)).toEqual(points[0]);
    expect(points.length).toBeGreaterThan(12);
    expect(points.length).toBeLessThan(40);
  });

  it('becomes one point if it is one place, never −0', () => {
    expect(simplified([{ x: -0.2, y: 12.5 }])).toEqual([[0, 13]]);
    expect(
      simplified([
        { x: 1, y: 1 },
        { x: 1.2, y: 1.1 },
      ]),
    ).toEqual([[1, 1]]);
  });

  it('is never further than 1 mm and the rounding from any of 20,000 places, with fewer than half the points', () => {
    for (const seed of [1, 2]) {
      const path = scribble(seed, 20_000);
      const points = simplified(path);
      const probes = path.filter((_, index) => index % 50 === 0);
      expect(Math.max(...probes.map((place) => distanceMm(place, points)))).toBeLessThanOrEqual(1 + Math.SQRT1_2);
      expect(points.length).toBeLessThan(10_000);
      expect(
        points.every(([x, y], index) => index === 0 || x !== points[index - 1]?.[0] || y !== points[index - 1]?.[1]),
      ).toBe(true);
    }
  });
});
