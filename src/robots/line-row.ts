/** Shared by robots with line sensors: rows that measure the ground and are reported by I2C, and pairs that tell light from dark. */
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import { BOTH_SIDES, type Side } from '#devices/dc-motor';
import { createLineComparator, type LineComparator, type LineView } from '#devices/line-sensor';
import type { LineSensorState, RobotContext } from './robot';
import { scaled } from './sonar';

/** A line sensor's name and its place in the robot frame, on the real robot. */
export interface LinePlace<Name extends string> {
  readonly name: Name;
  readonly atMm: Vec;
}

/** How the sensors of one robot measure. */
export interface LineMeasure {
  /** Radius of each sensor's spot, in mm on the real robot. */
  readonly spotRadiusMm: number;
  /** Readings on black and on bare floor, in the robot's own unit. Linear in between. */
  readonly black: number;
  readonly floor: number;
  /** The highest reading: silver returns more than bare floor. */
  readonly most: number;
}

/** The floor below a robot. */
type FloorContext = Pick<RobotContext, 'ground' | 'beforePaint' | 'scale'>;

/** The line sensors of one robot. */
export interface LineRow<Name extends string> {
  readonly isBright: (name: Name) => boolean;
  /** Reading of this sensor, a whole number in the robot's own unit. */
  readonly reading: (name: Name) => number;
  /** Notes that a step of the world has passed. Call it after each. */
  sample(): void;
  /** In the order of the places. */
  states(): LineSensorState[];
  /** Call it when the robot goes. */
  readonly stop: Stop;
}

/**
 * Mounts line sensors on a robot of any scale; each looks at the ground once. A sensor that reads differently from the
 * others decides between light and dark as if it saw what its reading means to them.
 */
export function mountLineRow<Name extends string>(
  { ground, beforePaint, scale, lineReadings }: FloorContext & Pick<RobotContext, 'lineReadings'>,
  places: readonly LinePlace<Name>[],
  { spotRadiusMm, black, floor, most }: LineMeasure,
): LineRow<Name> {
  const sensors = new Map<Name, LineComparator>(
    places.map(({ name, atMm }) => {
      const spot = scaled(atMm, scale);
      const own = lineReadings[name] ?? { black, floor };
      const seen = (reflectance: number): number => own.black + (own.floor - own.black) * reflectance;
      const seenByType = (reading: number): number => (reading - black) / (floor - black);
      const plain: LineView['look'] = (ago) => ground(spot, spotRadiusMm * scale, ago);
      const isPlain = own.black === black && own.floor === floor;
      const look: LineView['look'] = isPlain ? plain : (ago) => seenByType(seen(plain(ago)));
      return [name, createLineComparator({ look, beforePaint })];
    }),
  );
  const isBright = (name: Name): boolean => sensors.get(name)?.isBright() ?? false;
  const reading = (name: Name): number => {
    const value = Math.round(black + (floor - black) * (sensors.get(name)?.reflectance() ?? 0));
    return Math.min(most, Math.max(0, value));
  };
  return {
    isBright,
    reading,
    sample: () => sensors.forEach((sensor) => sensor.sample()),
    states: () => places.map(({ name, atMm }) => ({ name, atMm, bright: isBright(name), reading: reading(name) })),
    stop: () => sensors.forEach((sensor) => sensor.stop()),
  };
}

/** Two line sensors of one robot, left and right. */
export interface LinePair<Sensor> {
  readonly sensors: Readonly<Record<Side, Sensor>>;
  /** Notes that a step of the world has passed. Call it after each. */
  sample(): void;
  states(): LineSensorState[];
  /** Call it when the robot goes. */
  readonly stop: Stop;
}

/**
 * Mounts two line sensors on a robot of any scale.
 *
 * @param atMm their places, robot frame, on the real robot
 * @param make makes one from its view of the ground
 */
export function mountLinePair<Sensor extends Pick<LineComparator, 'sample' | 'isBright' | 'stop'>>(
  { ground, beforePaint, scale }: FloorContext,
  atMm: Readonly<Record<Side, Vec>>,
  spotRadiusMm: number,
  make: (view: LineView, side: Side) => Sensor,
): LinePair<Sensor> {
  const mount = (side: Side): Sensor => {
    const spot = scaled(atMm[side], scale);
    return make({ look: (ago) => ground(spot, spotRadiusMm * scale, ago), beforePaint }, side);
  };
  const sensors = { left: mount('left'), right: mount('right') };
  return {
    sensors,
    sample: () => {
      sensors.left.sample();
      sensors.right.sample();
    },
    states: () => BOTH_SIDES.map((name) => ({ name, atMm: atMm[name], bright: sensors[name].isBright() })),
    stop: () => {
      sensors.left.stop();
      sensors.right.stop();
    },
  };
}
