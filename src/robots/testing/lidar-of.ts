import type { LidarState } from '../robot';

/** The sight of a lidar at the origin, which looks along x: `row` at eye level, the floor in the lowest row, nothing else. */
export interface Seen {
  readonly row: readonly (number | null)[];
  readonly size?: LidarState['size'];
  readonly headingRad?: number;
  /** The cells that the program has just read. */
  readonly asked?: readonly number[];
}

/** The depth of the floor in the lowest row: 104 mm / tan 26.25°. */
const FLOOR_MM = 211;

/** The picture of a lidar with a field of 60°. */
export function lidarOf({ row, size = 8, headingRad = 0, asked = [] }: Seen): LidarState {
  const cells = Array.from({ length: size * size }, (_, cell) => ({ cell, line: Math.floor(cell / size) }));
  return {
    ...{ fromMm: { x: 0, y: 0 }, headingRad, openingRad: Math.PI / 3, size },
    depthMm: cells.map(({ cell, line }) => {
      if (line === size / 2 - 1) return row[cell % size] ?? null;
      return line === size - 1 ? FLOOR_MM : null;
    }),
    floor: cells.map(({ line }) => line === size - 1),
    asked: cells.map(({ cell }) => asked.includes(cell)),
  };
}
