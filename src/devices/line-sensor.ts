/**
 * A reflective line sensor: an infrared LED, a phototransistor and a comparator. Its output is 1 on light ground and 0
 * on dark ground or with nothing below, on a wire (`attachLineSensor`) or inside a robot that reports it by I2C
 * (`createLineComparator`).
 * Source of the polarity: docstrings in Tiger-Jython/Robotics-Libraries mbrobot.py and tkilla77/maqueen.
 */
import type { Level, Wire } from '#board/wires/wire';
import type { Stop } from '#core/stop';

/**
 * Comparator thresholds on the reflectance seen, 0 black … 1 bare floor: dark below the first, light above the second,
 * no change in between. Chosen symmetrically around half coverage: the gap keeps the output steady while a sensor rests
 * on an edge. It is so narrow that no gray of a floor picture (fifteenths, so 0.467 and 0.533) and no paint lies in it:
 * on such a floor the output would never change again.
 */
export const DARK_BELOW = 0.47;
export const LIGHT_ABOVE = 0.53;

/** A sensor with a digital value. */
export interface LineComparator {
  /** Looks at the ground. Call it after each step of the world, see `attachLineSensor`. */
  sample(): void;
  isBright(): boolean;
  /** The last reading: 0 black … 1 bare floor. */
  reflectance(): number;
}

/**
 * Makes a comparator and looks at the ground once.
 *
 * @param look what the sensor sees now, 0 black … 1 bare floor
 */
export function createLineComparator(look: () => number): LineComparator {
  let seen = look();
  let isBright = seen >= (DARK_BELOW + LIGHT_ABOVE) / 2;
  return {
    sample: () => {
      seen = look();
      if (seen > LIGHT_ABOVE) isBright = true;
      if (seen < DARK_BELOW) isBright = false;
    },
    isBright: () => isBright,
    reflectance: () => seen,
  };
}

/** The sensor on a wire as its owner sees it. */
export interface LineSensor {
  /** Looks at the ground and puts the result on the wire. */
  sample(): void;
  isBright(): boolean;
  readonly stop: Stop;
}

/**
 * Puts a line sensor on a wire and looks at the ground once.
 *
 * The ground below a sensor changes only when the world moves, so the owner calls `sample` after every step of the
 * world; between two steps the wire holds what the last one gave, however often the program reads.
 *
 * @param reflectance what the sensor sees now, 0 black … 1 bare floor
 */
export function attachLineSensor(wire: Wire, reflectance: () => number): LineSensor {
  const output = wire.connect('line sensor');
  const comparator = createLineComparator(reflectance);
  let level: Level = comparator.isBright() ? 1 : 0;
  output.drive(level);
  return {
    sample: () => {
      comparator.sample();
      const next: Level = comparator.isBright() ? 1 : 0;
      if (next === level) return;
      level = next;
      output.drive(level);
    },
    isBright: () => comparator.isBright(),
    stop: output.detach,
  };
}
