import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';

import type { Cells } from './even-light';
import { emptyPixels, type Pixels } from './pixels';
import type { Quad } from './quad';
import { brightnessOfCells, FULL_BRIGHTNESS } from './raster';
import { goodThreshold, evenedIf, levelsOf, type SensorView } from './sensor-view';
import { straightened } from './straighten';

const line: SensorView = { steps: 'line', thresholdPercent: 50, isEven: false };
/** Cells from shares of full brightness, in percent. */
const cells = (columns: number, ...percents: readonly number[]): Cells => ({
  columns,
  rows: percents.length / columns,
  brightness: Uint16Array.from(percents, (percent) => Math.round((percent * FULL_BRIGHTNESS) / 100)),
});

describe('what line sensors see of a picture', () => {
  it('is line or floor, by a threshold', () => {
    const given = cells(4, 10, 49, 50, 90);
    expect([...levelsOf(given, line)]).toEqual([0, 0, 15, 15]);
    expect([...levelsOf(given, { ...line, thresholdPercent: 20 })]).toEqual([0, 15, 15, 15]);
  });

  it('is all sixteen greys where that is wanted', () =>
    expect([...levelsOf(cells(4, 0, 20, 40, 100), { ...line, steps: 'greys' })]).toEqual([0, 3, 6, 15]));

  it('parts dark from bright by itself, in the middle between them', () => {
    expect(goodThreshold(cells(6, 10, 10, 10, 80, 80, 80))).toBe(46);
    expect(goodThreshold(cells(6, 30, 30, 90, 90, 90, 90))).toBe(61);
  });

  it('takes half where there is nothing to part', () => expect(goodThreshold(cells(2, 100, 100))).toBe(50));
});

describe('light that is made even', () => {
  /** A line of one cell in each tenth column, under a lamp at the left that is three times as bright there. */
  const lit = (): Cells => {
    const percents = Array.from({ length: 100 * 60 }, (_, cell) => {
      const column = cell % 100;
      return (90 - 0.6 * column) * (column % 10 === 5 ? 0.2 : 1);
    });
    return cells(100, ...percents);
  };

  it('makes paper bright and lines dark on both sides of a lamp, where no threshold did', () => {
    const levels = (isEven: boolean): number => {
      const judged = evenedIf(lit(), isEven);
      const seen = levelsOf(judged, { ...line, thresholdPercent: goodThreshold(judged) });
      return seen.reduce((wrong, level, cell) => wrong + ((level === 0) === (cell % 10 === 5) ? 0 : 1), 0);
    };
    expect(levels(false)).toBeGreaterThan(100);
    expect(levels(true)).toBe(0);
  });

  it('leaves what is wide and dark dark', () => {
    const given = cells(100, ...Array.from({ length: 100 * 60 }, (_, cell) => (cell % 100 < 20 ? 8 : 90)));
    const judged = evenedIf(given, true);
    expect(levelsOf(judged, line)[3000]).toBe(0);
    expect(levelsOf(judged, line)[3050]).toBe(15);
  });
});

describe('a line on a photograph', () => {
  /** Half the width of the line, and its way: an oval on a sheet of 1200 × 900 mm. */
  const HALF_MM = 10;
  const fromLine = (x: number, y: number): number => {
    const along = Math.max(Math.abs(x - 600) - 300, 0);
    return Math.abs(Math.sqrt(along * along + (y - 450) * (y - 450)) - 250);
  };
  /** The sheet in the photograph of 800 × 600 pixels, taken from aside. */
  const sheet: Quad = [
    [164, 122],
    [622, 94],
    [744, 530],
    [66, 496],
  ];

  /** The photograph: each of its pixels shows a place of the sheet or the table, in the light of a lamp, with noise. */
  function photograph(): Pixels {
    const photo = emptyPixels(800, 600);
    const rng = createRng(7);
    const width = 1600;
    // A fine drawing of the sheet, whose places are put where the camera sees them.
    photo.data.fill(90);
    for (let v = 0; v < (width * 3) / 4; v += 1)
      for (let u = 0; u < width; u += 1) {
        const [x, y] = seenAt(u / width, (4 * v) / (3 * width));
        const at = 4 * (Math.floor(y) * 800 + Math.floor(x));
        const paper = fromLine((1200 * u) / width, (900 * 4 * v) / (3 * width)) < HALF_MM ? 40 : 235;
        const grey = paper * (1 - (0.5 * x) / 800) * (x + y > 900 ? 0.75 : 1) + 24 * (rng.unit() - 0.5);
        photo.data.set([grey, grey, grey, 255], at);
      }
    return photo;
  }
  /** Place in the photograph of a place of the sheet (0 … 1 from its upper left). */
  function seenAt(u: number, v: number): readonly [number, number] {
    const [one, two, three, four] = sheet;
    const [dx1, dx2, sx] = [two[0] - three[0], four[0] - three[0], one[0] - two[0] + three[0] - four[0]];
    const [dy1, dy2, sy] = [two[1] - three[1], four[1] - three[1], one[1] - two[1] + three[1] - four[1]];
    const whole = dx1 * dy2 - dx2 * dy1;
    const [g, h] = [(sx * dy2 - dx2 * sy) / whole, (dx1 * sy - sx * dy1) / whole];
    const depth = g * u + h * v + 1;
    const at = (i: 0 | 1): number =>
      ((two[i] - one[i] + g * two[i]) * u + (four[i] - one[i] + h * four[i]) * v + one[i]) / depth;
    return [at(0), at(1)];
  }

  it('is found where it lies on the sheet, through perspective, a shadow and noise: 99 cells of 100', () => {
    const straight = straightened(photograph(), sheet, { width: 600, height: 450 });
    const brightness = brightnessOfCells(straight, 600, 450);
    const judged = evenedIf({ columns: 600, rows: 450, brightness }, true);
    const levels = levelsOf(judged, { ...line, thresholdPercent: goodThreshold(judged) });
    let [wrong, far] = [0, 0];
    levels.forEach((level, cell) => {
      const away = fromLine(2 * (cell % 600) + 1, 2 * Math.floor(cell / 600) + 1);
      if ((level === 0) === away < HALF_MM) return;
      wrong += 1;
      if (Math.abs(away - HALF_MM) > 6) far += 1;
    });
    expect(wrong / levels.length).toBeLessThan(0.01);
    expect(far / levels.length).toBeLessThan(0.001);
  });
});
