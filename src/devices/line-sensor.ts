/**
 * A reflective line sensor with a digital output: an infrared LED, a phototransistor and a comparator.
 * The output is 1 on light ground and 0 on dark ground or with nothing below.
 * Source of the polarity: docstrings in Tiger-Jython/Robotics-Libraries mbrobot.py and tkilla77/maqueen.
 */
import type { Level, Wire } from '#board/wire';
import type { Stop } from '#core/stop';

/**
 * Comparator thresholds on the reflectance seen, 0 black … 1 bare floor: dark below the first, light above the second,
 * as it was in between. Chosen symmetrically around half coverage: the gap keeps the output steady while a sensor
 * rests on an edge, and is narrower than 1 mm of way for the sensor spots of the robots here.
 */
export const DARK_BELOW = 0.45;
export const LIGHT_ABOVE = 0.55;

/** The sensor as its owner sees it. */
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
  let level: Level = reflectance() >= (DARK_BELOW + LIGHT_ABOVE) / 2 ? 1 : 0;
  output.drive(level);
  return {
    sample: () => {
      const seen = reflectance();
      const next: Level = seen > LIGHT_ABOVE ? 1 : seen < DARK_BELOW ? 0 : level;
      if (next === level) return;
      level = next;
      output.drive(level);
    },
    isBright: () => level === 1,
    stop: output.detach,
  };
}
