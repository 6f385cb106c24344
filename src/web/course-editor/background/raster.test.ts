import { describe, expect, it } from 'vitest';
import { createRaster } from './raster';

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
  const raster = createRaster(rows[0]?.length ?? 0, rows.length, columns, cellRows);
  raster.add(pixels(rows));
  return [...raster.levels()];
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

  it('are the same whether the picture comes at once or in strips', () => {
    const rows = ['#.o#.', '.o##o', 'oo..#', '#####', '.r.r.', 'o#o#o', '.....'];
    const whole = createRaster(5, 7, 3, 4);
    whole.add(pixels(rows));
    const strips = createRaster(5, 7, 3, 4);
    for (const row of rows) strips.add(pixels([row]));
    expect([...strips.levels()]).toEqual([...whole.levels()]);
  });

  it('stay exact for the largest picture: 40 million white pixels are all bare floor', () => {
    const raster = createRaster(40_000, 1000, 3, 1);
    const row = new Uint8ClampedArray(4 * 40_000).fill(255);
    for (let y = 0; y < 1000; y += 1) raster.add(row);
    expect([...raster.levels()]).toEqual([15, 15, 15]);
  });
});
