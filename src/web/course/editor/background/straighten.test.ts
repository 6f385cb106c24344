import { describe, expect, it } from 'vitest';

import { emptyPixels, quarterTurned, type Pixels } from './pixels';
import { wholeOf, type Quad } from './quad';
import { straightened } from './straighten';

/** A grey picture whose pixel at x, y has this brightness. */
function picture(width: number, height: number, greyAt: (x: number, y: number) => number): Pixels {
  const pixels = emptyPixels(width, height);
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1) {
      const grey = greyAt(x, y);
      pixels.data.set([grey, grey, grey, 255], 4 * (y * width + x));
    }
  return pixels;
}
const greys = ({ data }: Pixels): number[] => [...data].filter((_, index) => index % 4 === 0);

describe('a straightened picture', () => {
  it('is the same picture when its corners are those of the whole, to the last bit', () => {
    const given = picture(37, 23, (x, y) => (x * 7 + y * 13) % 256);
    const same = straightened(given, wholeOf(given), given);
    expect([...same.data]).toEqual([...given.data]);
  });

  it('has the corner that comes first at the upper left: a turned sheet comes upright', () => {
    const given = picture(2, 2, (x, y) => [10, 20, 30, 40][2 * y + x] ?? 0);
    const [one, two, three, four] = wholeOf(given);
    expect(greys(straightened(given, [four, one, two, three], given))).toEqual([30, 10, 40, 20]);
  });

  it('sees a sheet from above that was photographed from aside: its middle line stays in the middle', () => {
    // In perspective the diagonals of the sheet cross at its middle, above the middle of its outline.
    const sheet: Quad = [
      [100, 0],
      [200, 0],
      [300, 200],
      [0, 200],
    ];
    const crossing = 50; // the diagonals from [100, 0] to [300, 200] and from [200, 0] to [0, 200]
    const given = picture(300, 200, (_, y) => (y < crossing ? 0 : 200));
    const rows = greys(straightened(given, sheet, { width: 1, height: 100 }));
    expect(rows.findIndex((grey) => grey > 100)).toBe(50);
  });

  it('mixes neighbours where it falls between them', () => {
    const given = picture(2, 1, (x) => (x === 0 ? 0 : 200));
    expect(greys(straightened(given, wholeOf(given), { width: 4, height: 1 }))).toEqual([0, 50, 150, 200]);
  });
});

describe('a picture turned by a quarter', () => {
  it('has its left side above', () => {
    const turned = quarterTurned(picture(3, 2, (x, y) => 10 * y + x));
    expect([turned.width, turned.height]).toEqual([2, 3]);
    expect(greys(turned)).toEqual([10, 0, 11, 1, 12, 2]);
  });

  it('is itself again after four', () => {
    const given = picture(5, 3, (x, y) => x * y);
    expect([...quarterTurned(quarterTurned(quarterTurned(quarterTurned(given)))).data]).toEqual([...given.data]);
  });
});
