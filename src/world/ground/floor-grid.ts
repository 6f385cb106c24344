import type { FloorGrid } from '../shapes';
import { discShareLeftBelow } from './coverage';

/** Cells finer than this are merged. Chosen: no sensor tells them apart, and a spot has a bounded number of cells. */
const FINEST_MM = 1;

/** A picture on the floor, ready to be sampled. The floor beside it is bare. */
export interface FloorPicture {
  /** Reflectance at a point. */
  at(x: number, y: number): number;
  /** Mean reflectance under a round spot: every cell counts with exactly its share of the spot. */
  under(x: number, y: number, radius: number): number;
}

/** Throws RangeError if the number of reflectances differs from the number of cells. */
export function createFloorPicture(grid: FloorGrid): FloorPicture {
  const { columns, rows, reflectances } = merged(grid);
  const { x: left, y: bottom } = grid.atMm;
  const width = grid.sizeMm.x / columns;
  const height = grid.sizeMm.y / rows;

  /** Row 0 is the lowest here. */
  const cell = (column: number, row: number): number =>
    column < 0 || row < 0 || column >= columns || row >= rows
      ? 1
      : (reflectances[(rows - 1 - row) * columns + column] ?? 1);

  return {
    at: (x, y) => cell(Math.floor((x - left) / width), Math.floor((y - bottom) / height)),
    under(x, y, radius) {
      const clamp = (value: number, count: number): number => Math.min(Math.max(Math.floor(value), -1), count);
      const firstColumn = clamp((x - radius - left) / width, columns);
      const lastColumn = clamp((x + radius - left) / width, columns);
      const firstRow = clamp((y - radius - bottom) / height, rows);
      const lastRow = clamp((y + radius - bottom) / height, rows);
      /** Right or upper side of a cell in the frame of the disc of radius 1; the last ones reach beyond the spot. */
      const side = (index: number, last: number, origin: number, size: number, middle: number): number =>
        index === last ? 1 : (origin + (index + 1) * size - middle) / radius;
      let sum = 0;
      let below: number[] = [];
      for (let row = firstRow; row <= lastRow; row++) {
        const top = side(row, lastRow, bottom, height, y);
        const here: number[] = [];
        let leftShare = 0;
        for (let column = firstColumn; column <= lastColumn; column++) {
          const share = discShareLeftBelow(side(column, lastColumn, left, width, x), top);
          const belowShare = below[column - firstColumn] ?? 0;
          sum += (share - belowShare - leftShare) * cell(column, row);
          leftShare = share - belowShare;
          here.push(share);
        }
        below = here;
      }
      return sum;
    },
  };
}

/** The grid with neighbouring cells merged until they are wide and high enough. */
function merged({ columns, rows, sizeMm, reflectances }: FloorGrid): Omit<FloorGrid, 'atMm' | 'sizeMm'> {
  if (reflectances.length !== columns * rows)
    throw new RangeError(
      `A floor of ${columns} × ${rows} cells needs as many reflectances, not ${reflectances.length}.`,
    );
  const across = Math.max(1, Math.ceil((FINEST_MM * columns) / sizeMm.x));
  const up = Math.max(1, Math.ceil((FINEST_MM * rows) / sizeMm.y));
  if (across === 1 && up === 1) return { columns, rows, reflectances };
  const newColumns = Math.ceil(columns / across);
  const newRows = Math.ceil(rows / up);
  const means = new Float32Array(newColumns * newRows);
  const firstOf = (index: number, count: number, newCount: number): number => Math.floor((index * count) / newCount);
  for (let row = 0; row < newRows; row++) {
    const fromRow = firstOf(row, rows, newRows);
    const toRow = firstOf(row + 1, rows, newRows);
    for (let column = 0; column < newColumns; column++) {
      const fromColumn = firstOf(column, columns, newColumns);
      const toColumn = firstOf(column + 1, columns, newColumns);
      let sum = 0;
      for (let i = fromRow; i < toRow; i++)
        for (let j = fromColumn; j < toColumn; j++) sum += reflectances[i * columns + j] ?? 1;
      means[row * newColumns + column] = sum / ((toRow - fromRow) * (toColumn - fromColumn));
    }
  }
  return { columns: newColumns, rows: newRows, reflectances: means };
}
