import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import type { Vec } from '#core/geometry';
import { bandCoverage, discShareLeftOf } from './coverage';
import type { StrokeShape } from '../shapes';
import { createGround } from './ground';

const line = (y: number, widthMm: number, reflectance = 0) => ({
  pointsMm: [
    { x: 100, y },
    { x: 500, y },
  ],
  widthMm,
  reflectance,
});

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
});

const strokeOf = (widthMm: number, reflectance: number, ...xy: readonly number[]): StrokeShape => ({
  pointsMm: xy.flatMap((x, i) => (i % 2 === 0 ? [{ x, y: xy[i + 1] ?? 0 }] : [])),
  widthMm,
  reflectance,
});

/** A polyline that turns by 15° every 13 mm. */
const CURVE = strokeOf(
  20,
  0,
  ...Array.from({ length: 25 }, (_, i) => [
    100 + 50 * Math.cos((i * Math.PI) / 12),
    100 + 50 * Math.sin((i * Math.PI) / 12),
  ]).flat(),
);

/** The drawings around (100 | 100), later strokes over earlier ones. */
const drawings: readonly (readonly [string, readonly StrokeShape[]])[] = [
  ['a crossing', [strokeOf(20, 0, 20, 100, 180, 100), strokeOf(20, 0, 100, 20, 100, 180)]],
  ['a crossing of thin lines', [strokeOf(3, 0, 20, 100, 180, 100), strokeOf(3, 0, 100, 20, 100, 180)]],
  ['a line that crosses itself', [strokeOf(20, 0, 20, 100, 180, 100, 180, 180, 60, 30)]],
  ['a right angle', [strokeOf(20, 0, 20, 100, 100, 100, 100, 20)]],
  ['a sharp corner of a thin line', [strokeOf(4, 0, 20, 100, 100, 100, 30, 140)]],
  ['a round end', [strokeOf(20, 0, 20, 100, 100, 100)]],
  ['the end of a line of 2 mm', [strokeOf(2, 0, 20, 100, 100, 100)]],
  ['a dot of 5 mm', [strokeOf(5, 0, 100, 100)]],
  ['two lines side by side', [strokeOf(20, 0, 20, 100, 180, 100), strokeOf(20, 0, 20, 120, 180, 120)]],
  ['a line drawn twice', [strokeOf(20, 0, 20, 100, 180, 100), strokeOf(20, 0, 20, 100, 180, 100)]],
  ['a thin white line over a gray one', [strokeOf(20, 0.5, 20, 100, 180, 100), strokeOf(6, 1, 60, 60, 140, 140)]],
  ['a curve', [CURVE]],
];

/** The reading of a spot, from a square pattern of about 2,000 points in it. */
function sampled(strokes: readonly StrokeShape[], at: Vec, radius: number, floor = (_at: Vec): number => 1): number {
  const SIDE = 50;
  let sum = 0;
  let points = 0;
  for (let i = 0; i < SIDE * SIDE; i++) {
    const dx = ((i % SIDE) + 0.5) / (SIDE / 2) - 1;
    const dy = (Math.floor(i / SIDE) + 0.5) / (SIDE / 2) - 1;
    if (dx * dx + dy * dy > 1) continue;
    const point = { x: at.x + dx * radius, y: at.y + dy * radius };
    points++;
    sum += strokes.findLast((stroke) => isInk(stroke, point))?.reflectance ?? floor(point);
  }
  return sum / points;
}

const isInk = ({ pointsMm, widthMm }: StrokeShape, { x, y }: Vec): boolean =>
  pointsMm.some((b, i) => {
    const a = pointsMm[i - 1] ?? b;
    const [ux, uy] = [b.x - a.x, b.y - a.y];
    const share = Math.min(Math.max(((x - a.x) * ux + (y - a.y) * uy) / (ux * ux + uy * uy || 1), 0), 1);
    return Math.hypot(x - a.x - share * ux, y - a.y - share * uy) <= widthMm / 2;
  });

/** Root mean square and greatest difference from the pattern, at places where the spot sees an edge. */
function errorsOf(strokes: readonly StrokeShape[], radius: number) {
  const ground = createGround();
  for (const stroke of strokes) ground.addStroke(stroke);
  const rng = createRng(5);
  let squares = 0;
  let greatest = 0;
  let places = 0;
  while (places < 150) {
    const at = { x: 70 + 60 * rng.unit(), y: 70 + 60 * rng.unit() };
    const seen = ground.reflectanceAt(at.x, at.y, radius);
    if (seen === 0 || seen === 0.5 || seen === 1) continue;
    places++;
    const error = Math.abs(seen - sampled(strokes, at, radius));
    squares += error * error;
    greatest = Math.max(greatest, error);
  }
  return { rms: Math.sqrt(squares / places), greatest };
}

describe('what a spot sees is what is drawn', () => {
  // The pattern itself is up to 0.018 off: with an edge along its rows.
  it.each(drawings)(
    'at %s is within 0.008 in the mean of 2,000 points, nowhere more than 0.02 off',
    (_what, strokes) => {
      for (const radius of [3, 1.5]) {
        const { rms, greatest } = errorsOf(strokes, radius);
        expect(rms).toBeLessThan(0.008);
        expect(greatest).toBeLessThan(0.02);
      }
    },
  );

  it('exactly beside a straight piece, inside and outside', () => {
    const ground = createGround();
    ground.addStroke(strokeOf(20, 0, 0, 100, 200, 100));
    for (const distance of [0, 6.9, 7.1, 8.5, 10, 12.9, 13.1])
      expect(ground.reflectanceAt(100, 100 + distance, 3)).toBeCloseTo(1 - bandCoverage(distance, 10, 3), 14);
  });

  it('holds for pieces longer than the largest cells, too, and across negative places', () => {
    const ground = createGround();
    ground.addStroke(strokeOf(10, 0, -3000, -2000, 9000, 6000));
    for (let share = 0.001; share < 1; share += 0.0037)
      expect(ground.reflectanceAt(-3000 + 12_000 * share, -2000 + 8000 * share, 3)).toBe(0);
  });
});

describe('strokes that come and go', () => {
  it('leave nothing behind when they are taken away', () => {
    const ground = createGround();
    const below = ground.addStroke(line(200, 20));
    const above = ground.addStroke(line(200, 10, 0.5));
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0.5);
    above.remove();
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0);
    below.remove();
    below.remove();
    for (let x = 95; x < 505; x += 1.7) expect(ground.reflectanceAt(x, 200, 3)).toBe(1);
  });

  it('cover each other by their layers, not by when they came', () => {
    const ground = createGround();
    const first = ground.addStroke(line(200, 20, 0.25));
    const second = ground.addStroke(line(200, 20, 0.75));
    first.setLayer(7);
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0.25);
    second.setLayer(8);
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0.75);
    ground.addStroke(line(200, 20, 0));
    expect(ground.reflectanceAt(300, 200, 3)).toBe(0);
  });
});

describe('a picture on the floor', () => {
  /** Two rows of three cells of 10 × 10 mm with the lower left corner at (50 | 20). */
  const grid = {
    ...{ atMm: { x: 50, y: 20 }, sizeMm: { x: 30, y: 20 }, columns: 3, rows: 2 },
    reflectances: Float32Array.of(0, 0.25, 0.5, 0.75, 1, 0),
  };
  const cellAt = ({ x, y }: Vec): number => {
    const [column, row] = [Math.floor((x - 50) / 10), 1 - Math.floor((y - 20) / 10)];
    const isInside = column >= 0 && column < 3 && row >= 0 && row < 2;
    return isInside ? (grid.reflectances[row * 3 + column] ?? 1) : 1;
  };

  it('is seen cell by cell, its first row above, with bare floor around it', () => {
    const ground = createGround();
    ground.setFloor(grid);
    const rows = [45, 35, 25, 15].map((y) => [45, 55, 65, 75, 85].map((x) => ground.reflectanceAt(x, y, 3)));
    expect(rows).toEqual([
      [1, 1, 1, 1, 1],
      [1, 0, 0.25, 0.5, 1],
      [1, 0.75, 1, 0, 1],
      [1, 1, 1, 1, 1],
    ]);
  });

  it('counts every cell with the part of it under the spot', () => {
    const ground = createGround();
    ground.setFloor(grid);
    expect(ground.reflectanceAt(60, 35, 3)).toBeCloseTo(0.125, 12);
    expect(ground.reflectanceAt(60, 30, 3)).toBeCloseTo((0 + 0.25 + 0.75 + 1) / 4, 12);
    const rng = createRng(2);
    for (const radius of [2, 6, 25])
      for (let i = 0; i < 40; i++) {
        const at = { x: 45 + 40 * rng.unit(), y: 15 + 30 * rng.unit() };
        expect(Math.abs(ground.reflectanceAt(at.x, at.y, radius) - sampled([], at, radius, cellAt))).toBeLessThan(0.02);
      }
  });

  it('lies under the strokes', () => {
    const ground = createGround();
    ground.setFloor(grid);
    const strokes = [strokeOf(4, 0, 40, 30, 100, 33), strokeOf(3, 1, 66, 10, 68, 60)];
    for (const stroke of strokes) ground.addStroke(stroke);
    const rng = createRng(3);
    for (let i = 0; i < 100; i++) {
      const at = { x: 50 + 30 * rng.unit(), y: 25 + 10 * rng.unit() };
      expect(Math.abs(ground.reflectanceAt(at.x, at.y, 3) - sampled(strokes, at, 3, cellAt))).toBeLessThan(0.03);
    }
    ground.setFloor(null);
    expect(ground.reflectanceAt(55, 39, 1)).toBe(1);
  });

  it('is the mean of cells that are too fine for any sensor', () => {
    const ground = createGround();
    const fine = { atMm: { x: 0, y: 0 }, sizeMm: { x: 100, y: 50 }, columns: 1000, rows: 1000 };
    ground.setFloor({ ...fine, reflectances: Float32Array.from({ length: 1_000_000 }, (_, i) => (i % 1000) % 2) });
    expect(ground.reflectanceAt(50, 25, 20)).toBeCloseTo(0.5, 12);
  });

  it('is refused when its reflectances are not as many as its cells', () => {
    expect(() => createGround().setFloor({ ...grid, rows: 3 })).toThrow(/3 × 3 cells .* not 6/);
  });
});
