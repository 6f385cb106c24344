import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import type { Vec } from '#core/geometry';
import { bandCoverage, discShareLeftOf } from './coverage';
import { createGround } from './strokes';

const line = (y: number, widthMm: number, reflectance = 0) => ({
  pointsMm: [
    { x: 100, y },
    { x: 500, y },
  ],
  widthMm,
  reflectance,
});

/** Share of a disc that lies within half a width of a polyline, by 2,000 points. */
const coveredShare = (points: readonly Vec[], widthMm: number, at: Vec, radius: number): number => {
  const rng = createRng(7);
  let inside = 0;
  let all = 0;
  while (all < 2000) {
    const [dx, dy] = [2 * rng.unit() - 1, 2 * rng.unit() - 1];
    if (dx * dx + dy * dy > 1) continue;
    all++;
    const [x, y] = [at.x + dx * radius, at.y + dy * radius];
    const near = points.some((b, i) => {
      const a = points[i - 1] ?? b;
      const [ux, uy] = [b.x - a.x, b.y - a.y];
      const share = Math.min(Math.max(((x - a.x) * ux + (y - a.y) * uy) / (ux * ux + uy * uy || 1), 0), 1);
      return Math.hypot(x - a.x - share * ux, y - a.y - share * uy) <= widthMm / 2;
    });
    if (near) inside++;
  }
  return inside / all;
};

describe('coverage of a disc', () => {
  it('is 0, a fifth, half and all at −1, −0.4919, 0 and 1', () => {
    expect([discShareLeftOf(-1), discShareLeftOf(0), discShareLeftOf(1)]).toEqual([0, 0.5, 1]);
    expect(discShareLeftOf(-0.4919)).toBeCloseTo(0.2, 4);
  });

  it('is the band’s share when the band is thinner than the disc', () => {
    expect(bandCoverage(0, 0.05, 1)).toBeCloseTo(0.2 / Math.PI, 3);
  });
});

describe('the floor', () => {
  it('is white where nothing is drawn and black in the middle of a line', () => {
    const ground = createGround();
    ground.addStroke(line(200, 20));
    expect(ground.reflectanceAt(300, 300, 3)).toBe(1);
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0);
  });

  it('is half grey on the edge of a line and goes over within the spot’s 6 mm', () => {
    const ground = createGround();
    ground.addStroke(line(200, 20));
    expect(ground.reflectanceAt(300, 210, 3)).toBeCloseTo(0.5, 12);
    expect(ground.reflectanceAt(300, 206.9, 3)).toBe(0);
    expect(ground.reflectanceAt(300, 213.1, 3)).toBe(1);
  });

  it('sees a line across the borders of grid cells', () => {
    const ground = createGround();
    ground.addStroke({ pointsMm: [{ x: 0, y: 0 }, { x: 900, y: 700 }], widthMm: 5, reflectance: 0 }); // prettier-ignore
    for (let share = 0.01; share < 1; share += 0.003) {
      expect(ground.reflectanceAt(900 * share, 700 * share, 2)).toBe(0);
    }
  });

  it('ends a line with the roundness of the pen', () => {
    const ground = createGround();
    ground.addStroke(line(200, 20));
    expect(ground.reflectanceAt(509, 200, 0.5)).toBe(0);
    expect(ground.reflectanceAt(511, 200, 0.5)).toBe(1);
    expect(ground.reflectanceAt(508, 208, 0.5)).toBe(1);
  });

  it('draws a single point as a dot', () => {
    const ground = createGround();
    ground.addStroke({ pointsMm: [{ x: 50, y: 50 }], widthMm: 10, reflectance: 0 });
    expect([ground.reflectanceAt(53, 50, 1), ground.reflectanceAt(57, 50, 1)]).toEqual([0, 1]);
  });

  it('stays black where two lines cross', () => {
    const ground = createGround();
    ground.addStroke(line(200, 20));
    ground.addStroke({ pointsMm: [{ x: 300, y: 100 }, { x: 300, y: 300 }], widthMm: 20, reflectance: 0 }); // prettier-ignore
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0);
    expect(ground.reflectanceAt(310, 200, 3)).toBe(0);
  });

  it('lets a later light line cover an earlier dark one', () => {
    const ground = createGround();
    ground.addStroke(line(200, 20));
    ground.addStroke(line(200, 10, 1));
    ground.addStroke(line(300, 20, 0.4));
    expect(ground.reflectanceAt(300, 200, 3)).toBe(1);
    expect(ground.reflectanceAt(300, 207.5, 1)).toBe(0);
    expect(ground.reflectanceAt(300, 300, 3)).toBeCloseTo(0.4, 12);
  });

  it('is within 0.02 of the true coverage along a curve of 20 mm width', () => {
    const points = Array.from({ length: 40 }, (_, i) => ({
      x: 400 + 200 * Math.cos(i / 7),
      y: 400 + 200 * Math.sin(i / 7),
    }));
    const ground = createGround();
    ground.addStroke({ pointsMm: points, widthMm: 20, reflectance: 0 });
    const rng = createRng(3);
    let squares = 0;
    for (let i = 0; i < 100; i++) {
      const angle = 5 * rng.unit() + 0.2;
      const radius = 185 + 30 * rng.unit();
      const at = { x: 400 + radius * Math.cos(angle), y: 400 + radius * Math.sin(angle) };
      const error = 1 - ground.reflectanceAt(at.x, at.y, 3) - coveredShare(points, 20, at, 3);
      squares += error * error;
    }
    expect(Math.sqrt(squares / 100)).toBeLessThan(0.02);
  });
});
