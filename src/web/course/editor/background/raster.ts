import { BRIGHTEST_LEVEL } from '#scene/background';

import type { Pixels } from './pixels';

/** Shares of red, green and blue in the brightness, in 256ths: ITU-R BT.709 (0.2126, 0.7152, 0.0722). */
const [RED, GREEN, BLUE] = [54, 183, 19];

/** A pixel of bare floor: full brightness and full alpha. */
const FLOOR = 256 * 255 * 255;

/** The brightness of bare floor in a cell: fine steps, of which 255 make one level. */
export const FULL_BRIGHTNESS = 255 * BRIGHTEST_LEVEL;

/** Brightness of a pixel over the floor, an integer 0 … `FLOOR`: where it is transparent, the floor shows. */
function brightnessOf(red: number, green: number, blue: number, alpha: number): number {
  return (RED * red + GREEN * green + BLUE * blue) * alpha + 256 * 255 * (255 - alpha);
}

/**
 * Averages the pixels of a picture over the cells of a grid, weighting each pixel by the part of it that lies in the
 * cell. All sums are integers below 2⁵³, so that the same pixels give the same figures in every engine.
 *
 * @param columns cells across; may exceed the number of pixels
 * @returns 0 (black) … `FULL_BRIGHTNESS` (bare floor) per cell, row by row from the upper left
 */
export function brightnessOfCells({ width, height, data }: Pixels, columns: number, rows: number): Uint16Array {
  // With pixels `columns` wide and `rows` high, cells `width` wide and `height` high, every overlap is an integer.
  const sums = new Float64Array(columns * rows);
  const across = new Float64Array(columns);
  for (let y = 0; y < height; y += 1) {
    across.fill(0);
    for (let x = 0; x < width; x += 1) {
      const i = 4 * (y * width + x);
      const value = brightnessOf(data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0, data[i + 3] ?? 0);
      share(x, columns, width, (column, part) => {
        across[column] = (across[column] ?? 0) + value * part;
      });
    }
    share(y, rows, height, (row, part) => {
      const at = row * columns;
      for (let column = 0; column < columns; column += 1)
        sums[at + column] = (sums[at + column] ?? 0) + (across[column] ?? 0) * part;
    });
  }
  const full = FLOOR * width * height;
  return Uint16Array.from(sums, (sum) => Math.floor((sum / full) * FULL_BRIGHTNESS + 0.5));
}

/** Calls `visit` with each cell that pixel number `pixel` overlaps, and by how much. */
function share(pixel: number, cells: number, pixels: number, visit: (cell: number, part: number) => void): void {
  const from = pixel * cells;
  const to = from + cells;
  for (let cell = Math.floor(from / pixels); cell * pixels < to; cell += 1)
    visit(cell, Math.min(to, (cell + 1) * pixels) - Math.max(from, cell * pixels));
}
