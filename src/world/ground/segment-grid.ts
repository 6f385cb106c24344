import type { Segment } from './segment';

/**
 * Sides of the cells, in mm. Small pieces lie in small cells and large ones in large cells, so that no piece lies in more
 * than about 64. Source: measured with 16, 32 and 64 mm; 32 is nearly as fast as 16 and takes a quarter of the memory.
 */
const CELLS_MM = [32, 128, 512, 2048] as const;

/** A piece spans at most this many cells of its grid along x or y. */
const SPAN = 8;

/** Finds pieces of strokes by position. */
export interface SegmentGrid {
  add(segment: Segment): void;
  remove(segment: Segment): void;
  /** Calls back for each piece whose ink may reach into a square about a place; for some pieces more than once. */
  near(x: number, y: number, reach: number, visit: (segment: Segment) => void): void;
}

/** The grid of one cell size. */
interface Level {
  readonly cellMm: number;
  readonly cells: Map<number, Segment[]>;
}

export function createSegmentGrid(): SegmentGrid {
  const levels = CELLS_MM.map((cellMm): Level => ({ cellMm, cells: new Map() }));
  const levelOf = ({ ex, ey, length, painted }: Segment): Level | undefined => {
    const extent = length * Math.max(Math.abs(ex), Math.abs(ey)) + 2 * painted.halfWidth;
    return levels.find(({ cellMm }) => extent <= SPAN * cellMm) ?? levels[levels.length - 1];
  };
  return {
    add(segment) {
      const level = levelOf(segment);
      if (!level) return;
      for (const key of keysOf(segment, level.cellMm)) {
        const cell = level.cells.get(key);
        if (cell) cell.push(segment);
        else level.cells.set(key, [segment]);
      }
    },
    remove(segment) {
      const level = levelOf(segment);
      if (!level) return;
      for (const key of keysOf(segment, level.cellMm)) {
        const rest = (level.cells.get(key) ?? []).filter((one) => one !== segment);
        if (rest.length > 0) level.cells.set(key, rest);
        else level.cells.delete(key);
      }
    },
    near(x, y, reach, visit) {
      for (const { cellMm, cells } of levels) {
        if (cells.size === 0) continue;
        const lastColumn = Math.floor((x + reach) / cellMm);
        const lastRow = Math.floor((y + reach) / cellMm);
        for (let column = Math.floor((x - reach) / cellMm); column <= lastColumn; column++)
          for (let row = Math.floor((y - reach) / cellMm); row <= lastRow; row++) {
            const cell = cells.get(keyOf(column, row));
            if (cell) for (const segment of cell) visit(segment);
          }
      }
    },
  };
}

/** Arenas go up to 10 m; 65 536 cells of 32 mm reach far beyond. */
const keyOf = (column: number, row: number): number => column * 65536 + row;

/** The cells that a piece's ink can reach, column by column. */
function* keysOf({ ax, ay, ex, ey, length, painted }: Segment, cellMm: number): Iterable<number> {
  const half = painted.halfWidth;
  const bx = ax + length * ex;
  const by = ay + length * ey;
  const [leftX, leftY, rightX, rightY] = ax <= bx ? [ax, ay, bx, by] : [bx, by, ax, ay];
  const slope = rightX > leftX ? (rightY - leftY) / (rightX - leftX) : 0;
  const lastColumn = Math.floor((rightX + half) / cellMm);
  for (let column = Math.floor((leftX - half) / cellMm); column <= lastColumn; column++) {
    // The part of the middle line whose ink can reach this column.
    const fromX = Math.max(leftX, column * cellMm - half);
    const toX = Math.min(rightX, (column + 1) * cellMm + half);
    const steep = rightX === leftX;
    const fromY = steep ? leftY : leftY + (fromX - leftX) * slope;
    const toY = steep ? rightY : leftY + (toX - leftX) * slope;
    const lastRow = Math.floor((Math.max(fromY, toY) + half) / cellMm);
    for (let row = Math.floor((Math.min(fromY, toY) - half) / cellMm); row <= lastRow; row++) yield keyOf(column, row);
  }
}
