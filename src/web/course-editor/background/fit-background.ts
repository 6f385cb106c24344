import { sceneLimits, type Background, type Point } from '#scene/scene';

/** Side of a cell in mm, unless that makes too many cells. Chosen: a line sensor sees a spot of about 2 mm. */
const CELL_MM = 2;

/**
 * Where a newly opened picture goes: in the middle of the arena, as large as fits without distorting it. And how many
 * cells its grid has: one every 2 mm, or larger ones if that would exceed the limit of a background.
 *
 * @param width in the same unit as `height`; both above 0
 */
export function fitBackground(width: number, height: number, arena: Point): Pick<Background, 'at' | 'size' | 'cells'> {
  const { min, max } = sceneLimits.backgroundMm;
  const scale = Math.min(arena[0] / width, arena[1] / height);
  const extent = (length: number): number => Math.min(max, Math.max(min, Math.round(length * scale)));
  const size: Point = [extent(width), extent(height)];
  const cellMm = Math.max(CELL_MM, Math.sqrt((size[0] * size[1]) / sceneLimits.cells));
  const across = Math.max(1, Math.round(size[0] / cellMm));
  const up = Math.max(1, Math.min(Math.round(size[1] / cellMm), Math.floor(sceneLimits.cells / across)));
  return {
    at: [Math.round((arena[0] - size[0]) / 2), Math.round((arena[1] - size[1]) / 2)],
    size,
    cells: [across, up],
  };
}
