/** Shared by robots that measure the ground with several line sensors and report them by I2C. */
import type { Vec } from '#core/geometry';
import { createLineComparator, type LineComparator } from '#devices/line-sensor';
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
}

/** The line sensors of one robot. */
export interface LineRow<Name extends string> {
  readonly isBright: (name: Name) => boolean;
  /** Reading of this sensor, a whole number in the robot's own unit. */
  readonly reading: (name: Name) => number;
  /** Looks at the ground. Call it after each step of the world. */
  sample(): void;
  /** In the order of the places. */
  states(): LineSensorState[];
}

/**
 * Mounts line sensors on a robot of any scale; each looks at the ground once. A sensor that reads differently from the
 * others decides between light and dark as if it saw what its reading means to them.
 */
export function mountLineRow<Name extends string>(
  { ground, scale, lineReadings }: Pick<RobotContext, 'ground' | 'scale' | 'lineReadings'>,
  places: readonly LinePlace<Name>[],
  { spotRadiusMm, black, floor }: LineMeasure,
): LineRow<Name> {
  const sensors = new Map<Name, LineComparator>(
    places.map(({ name, atMm }) => {
      const spot = scaled(atMm, scale);
      const own = lineReadings[name] ?? { black, floor };
      const seen = (reflectance: number): number => own.black + (own.floor - own.black) * reflectance;
      const seenByType = (reading: number): number => (reading - black) / (floor - black);
      const look = (): number => ground(spot, spotRadiusMm * scale);
      const isPlain = own.black === black && own.floor === floor;
      return [name, createLineComparator(isPlain ? look : () => seenByType(seen(look())))];
    }),
  );
  const isBright = (name: Name): boolean => sensors.get(name)?.isBright() ?? false;
  const reading = (name: Name): number => Math.round(black + (floor - black) * (sensors.get(name)?.reflectance() ?? 0));
  return {
    isBright,
    reading,
    sample: () => sensors.forEach((sensor) => sensor.sample()),
    states: () => places.map(({ name, atMm }) => ({ name, atMm, bright: isBright(name), reading: reading(name) })),
  };
}
