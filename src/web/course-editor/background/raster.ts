import { BRIGHTEST_LEVEL } from '#scene/background';

/** Turns a picture into the grid of a background, strip by strip, so that it is never in memory as a whole. */
export interface Raster {
  /**
   * Adds the next rows of pixels, from the top.
   *
   * @param rgba red, green, blue and alpha 0 … 255 per pixel, not premultiplied, row by row
   */
  add(rgba: ArrayLike<number>): void;
  /**
   * One level per cell, row by row from the upper left: 0 black … 15 bare floor. Read it once all rows have been added.
   */
  levels(): Uint8Array;
}

/** Shares of red, green and blue in the brightness, in 256ths: ITU-R BT.709 (0.2126, 0.7152, 0.0722). */
const [RED, GREEN, BLUE] = [54, 183, 19];

/** A pixel of bare floor: full brightness and full alpha. */
const FLOOR = 256 * 255 * 255;

/** Brightness of a pixel over the floor, an integer 0 … `FLOOR`: where it is transparent, the floor shows. */
function brightnessOf(red: number, green: number, blue: number, alpha: number): number {
  return (RED * red + GREEN * green + BLUE * blue) * alpha + 256 * 255 * (255 - alpha);
}

/**
 * Averages the pixels of a picture over the cells of a grid, weighting each pixel by the part of it that lies in the
 * cell. All sums are integers below 2⁵³, so that the same pixels give the same levels in every engine.
 *
 * @param widthPx up to 40 million pixels in all
 * @param columns cells across; may exceed the number of pixels
 */
export function createRaster(widthPx: number, heightPx: number, columns: number, rows: number): Raster {
  // With pixels `columns` wide and `rows` high, cells `widthPx` wide and `heightPx` high, every overlap is an integer.
  const sums = new Float64Array(columns * rows);
  const across = new Float64Array(columns);
  let row = 0;
  const addAcross = (rgba: ArrayLike<number>, start: number): void => {
    across.fill(0);
    for (let x = 0; x < widthPx; x += 1) {
      const i = start + 4 * x;
      const value = brightnessOf(rgba[i] ?? 0, rgba[i + 1] ?? 0, rgba[i + 2] ?? 0, rgba[i + 3] ?? 0);
      share(x, columns, widthPx, (column, part) => {
        across[column] = (across[column] ?? 0) + value * part;
      });
    }
  };
  return {
    add(rgba) {
      for (let start = 0; start < rgba.length && row < heightPx; start += 4 * widthPx, row += 1) {
        addAcross(rgba, start);
        share(row, rows, heightPx, (cellRow, part) => {
          const at = cellRow * columns;
          for (let column = 0; column < columns; column += 1)
            sums[at + column] = (sums[at + column] ?? 0) + (across[column] ?? 0) * part;
        });
      }
    },
    levels: () => levelsOf(sums, FLOOR * widthPx * heightPx),
  };
}

/** Calls `visit` with each cell that pixel number `pixel` overlaps, and by how much. */
function share(pixel: number, cells: number, pixels: number, visit: (cell: number, part: number) => void): void {
  const from = pixel * cells;
  const to = from + cells;
  for (let cell = Math.floor(from / pixels); cell * pixels < to; cell += 1)
    visit(cell, Math.min(to, (cell + 1) * pixels) - Math.max(from, cell * pixels));
}

function levelsOf(sums: Float64Array, full: number): Uint8Array {
  return Uint8Array.from(sums, (sum) => Math.min(BRIGHTEST_LEVEL, Math.floor((sum / full) * BRIGHTEST_LEVEL + 0.5)));
}
