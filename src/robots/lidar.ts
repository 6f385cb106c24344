/** Shared by robots with a matrix lidar: its place, its view, and the display of its picture. */
import { radOf } from '#core/angle';
import { exactTan } from '#core/exact-math';

import type { Vec } from '#core/geometry';
import { attachMatrixLidar, LIDAR_RANGE_MM, type LidarSize } from '#devices/matrix-lidar';
import type { DepthView } from '#world/probes/depth-grid';
import { LENS_HEIGHT_MM } from './lidar-fan';
import type { LidarState, RobotContext } from './robot';
import { scaled } from './sonar';

const OPENING_DEG = 60; // DFRobot SEN0628: 60° across and upright, 90° from corner to corner

/** Rows that look down less do not see the floor: chosen, of 8 rows the first below the horizon (3.75°). */
const LEAST_FLOOR_DEG = 5;

/** How long a cell is shown as read: chosen, two readings a second look like one that goes on. */
const SHOWN_READ_US = 500_000;

const tangentAt = (deg: number): number => exactTan(radOf(deg));

/** The middles of the cells, from the left or from the top: for 8 cells ±3.75°, 11.25°, 18.75° and 26.25°. */
const tangents = (size: LidarSize): readonly number[] =>
  Array.from({ length: size }, (_, cell) => tangentAt(OPENING_DEG / 2 - ((cell + 0.5) * OPENING_DEG) / size));

const viewOf = (size: LidarSize): DepthView => ({
  heightMm: LENS_HEIGHT_MM,
  columns: tangents(size),
  rows: tangents(size),
  rangeMm: LIDAR_RANGE_MM,
  leastFloorSlope: tangentAt(LEAST_FLOOR_DEG),
});

const VIEWS: Readonly<Record<LidarSize, DepthView>> = { 4: viewOf(4), 8: viewOf(8) };

/** A mounted lidar. */
export interface Lidar {
  /** The display of its picture now, whatever the program reads. */
  state(): LidarState;
  readonly stop: () => void;
}

/**
 * Mounts a level lidar on a robot of any scale, looking ahead.
 *
 * @param atMm place of its lens, robot frame, on the real robot
 */
export function mountLidar(context: RobotContext, atMm: Vec): Lidar {
  const { board, chassis, clock, depths, options, scale } = context;
  const from = scaled(atMm, scale);
  const look = (size: LidarSize) => depths(from, VIEWS[size]);
  const module = attachMatrixLidar(clock, board.i2c, (size) => look(size).map(({ depthMm }) => depthMm), {
    address: Number(options['lidarAddress']),
    startSize: options['lidar'] === '4x4' ? 4 : 8,
    emptyMm: options['lidarEmpty'] === '0' ? 0 : 4000,
    isTransposed: options['lidarOrder'] === 'transposed',
  });
  return {
    state: () => {
      const size = module.size();
      const cells = look(size);
      return {
        fromMm: chassis.toWorld(from),
        headingRad: chassis.pose().headingRad,
        openingRad: radOf(OPENING_DEG),
        size,
        depthMm: cells.map(({ depthMm }) => (depthMm === Infinity ? null : Math.round(depthMm))),
        floor: cells.map(({ isFloor }) => isFloor),
        asked: module.readWithin(SHOWN_READ_US),
      };
    },
    stop: module.stop,
  };
}
