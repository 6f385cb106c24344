import { describe, expect, it } from 'vitest';
import { brightnessOfCells, FULL_BRIGHTNESS } from './raster';
import { levelsOf } from './sensor-view';

/** A picture as text: `#` black, `.` white, `o` mid grey, ` ` transparent, `r` red. */
const COLOURS: Readonly<Record<string, readonly number[]>> = {
  '#': [0, 0, 0, 255],
  '.': [255, 255, 255, 255],
  o: [128, 128, 128, 255],
  r: [255, 0, 0, 255],
  ' ': [0, 0, 0, 0],
  '~': [0, 0, 0, 128],
};
const pixels = (rows: readonly string[]): number[] =>
  rows.flatMap((row) => Array.from(row).flatMap((sign) => COLOURS[sign] ?? []));

function levels(rows: readonly string[], columns: number, cellRows: number): number[] {
  const data = Uint8ClampedArray.from(pixels(rows));
  const brightness = brightnessOfCells({ width: rows[0]?.length ?? 0, height: rows.length, data }, columns, cellRows);
  const view = { steps: 'greys', thresholdPercent: 50, isEven: false } as const;
  return [...levelsOf({ columns, rows: cellRows, brightness }, view)];
}

describe('the levels of a picture', () => {
  it('are 0 for black, 15 for white and for what is transparent, row by row from the upper left', () => {
    expect(levels(['#.', ' o'], 2, 2)).toEqual([0, 15, 15, 8]);
  });

  it('take the brightness as the eye weighs colours: pure red is a fifth', () => {
    expect(levels(['r'], 1, 1)).toEqual([3]);
  });

  it('let half transparent black be half dark', () => {
    expect(levels(['~'], 1, 1)).toEqual([7]);
  });

  it('average all pixels of a cell, and those on its border by their part', () => {
    expect(levels(['#..', '#..'], 1, 1)).toEqual([10]);
    // Three pixels over two cells: the middle one is shared.
    expect(levels(['#.#'], 2, 1)).toEqual([5, 5]);
    expect(levels(['##.'], 2, 1)).toEqual([0, 10]);
  });

  it('spread a few pixels over many cells', () => {
    expect(levels(['#.'], 4, 2)).toEqual([0, 0, 15, 15, 0, 0, 15, 15]);
  });

  it('stay exact for the largest picture: 4 million white pixels are all bare floor', () => {
    const data = new Uint8ClampedArray(4 * 4_000_000).fill(255);
    const brightness = brightnessOfCells({ width: 2000, height: 2000, data }, 3, 1);
    expect([...brightness]).toEqual([FULL_BRIGHTNESS, FULL_BRIGHTNESS, FULL_BRIGHTNESS]);
  });
});
