import { sceneLimits, type Background, type Point } from '#scene/scene';

/** Side of a cell in mm, unless that makes too many cells. Chosen: less than half of a line sensor's spot. */
const CELL_MM = 2;

/** Sheets of paper by their sides in mm (ISO 216), the longer first. */
export const sheetsMm = { A4: [297, 210], A3: [420, 297], A2: [594, 420], A1: [841, 594] } as const;

/**
 * The size that a picture gets: as large as fits in the arena without distorting it, exactly the arena, or a sheet of
 * paper at true size.
 */
export type FloorSize = 'fit' | 'arena' | keyof typeof sheetsMm;

/**
 * Place of a newly opened picture: in the middle of the arena. And the number of its grid's cells: one every 2 mm, or
 * larger ones if that would exceed the limit of a background.
 *
 * @param width in the same unit as `height`; both above 0
 */
export function fitBackground(
  width: number,
  height: number,
  arena: Point,
  size: FloorSize = 'fit',
): Pick<Background, 'at' | 'size' | 'cells'> {
  const sizeMm = extentMm([width, height], arena, size);
  const cellMm = Math.max(CELL_MM, Math.sqrt((sizeMm[0] * sizeMm[1]) / sceneLimits.cells));
  const across = Math.max(1, Math.round(sizeMm[0] / cellMm));
  const up = Math.max(1, Math.min(Math.round(sizeMm[1] / cellMm), Math.floor(sceneLimits.cells / across)));
  return {
    at: [Math.round((arena[0] - sizeMm[0]) / 2), Math.round((arena[1] - sizeMm[1]) / 2)],
    size: sizeMm,
    cells: [across, up],
  };
}

function extentMm(picture: Point, arena: Point, size: FloorSize): Point {
  if (size === 'arena') return arena;
  if (size !== 'fit') {
    const [longer, shorter] = sheetsMm[size];
    return picture[0] >= picture[1] ? [longer, shorter] : [shorter, longer];
  }
  const { min, max } = sceneLimits.backgroundMm;
  const scale = Math.min(arena[0] / picture[0], arena[1] / picture[1]);
  const extent = (length: number): number => Math.min(max, Math.max(min, Math.round(length * scale)));
  return [extent(picture[0]), extent(picture[1])];
}
