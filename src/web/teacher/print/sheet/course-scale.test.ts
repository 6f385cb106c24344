import { describe, expect, it } from 'vitest';

import { barMm, drawnCourse } from './course-scale';

describe('the scale of a course on a worksheet', () => {
  it('is a whole number from 1:3 on, the largest drawing that fits: 120 × 90 cm on 178 mm is 1:7', () => {
    const { scale, size } = drawnCourse([1200, 900], [178, 260]);
    expect(scale).toBe(7);
    expect(size[0]).toBeCloseTo((1200 + 9.6) / 7);
  });

  it('is 1:1.5 for the smallest course, and never larger than the course', () => {
    expect(drawnCourse([200, 200], [178, 260]).scale).toBe(1.5);
    expect(drawnCourse([200, 200], [1000, 1000]).scale).toBe(1);
  });

  it('lets the largest course of 10 × 10 m fit, and one that is 50 times as long as wide', () => {
    for (const course of [
      [10_000, 10_000],
      [10_000, 200],
      [200, 10_000],
    ] as const) {
      const { size } = drawnCourse(course, [178, 90]);
      expect(size[0]).toBeLessThanOrEqual(178);
      expect(size[1]).toBeLessThanOrEqual(90);
    }
  });

  it('is shown by a bar of 1, 2 or 5 times a power of ten, 18 to 45 mm long on the sheet', () => {
    expect([1, 1.5, 7, 16, 57].map(barMm)).toEqual([20, 50, 200, 500, 2000]);
    for (let scale = 1; scale < 120; scale += 1) {
      expect(barMm(scale) / scale).toBeLessThanOrEqual(45);
      expect(barMm(scale) / scale).toBeGreaterThanOrEqual(17.9);
    }
  });
});
