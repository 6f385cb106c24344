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

/** The most steps of the world that a comparator looks back. Chosen: a quarter of a second. */
export const MOST_STEPS_BACK = 64;

/** The ground as a sensor sees it: 0 black … 1 bare floor. */
export interface LineView {
  /** Looks at the ground now, or as it was below the sensor so many steps of the world ago: after the last one 0 steps ago. */
  readonly look: (stepsAgo?: number) => number;
  /** Calls something each time before the floor changes. Left out: it never does. */
  readonly beforePaint?: (act: () => void) => Stop;
}

/** A sensor with a digital value. */
export interface LineComparator {
  /** Notes that a step of the world has passed. Call it after each. */
  sample(): void;
  isBright(): boolean;
  /** The last reading: 0 black … 1 bare floor. */
  reflectance(): number;
  /** From now on it does not hear of changes of the floor. */
  readonly stop: Stop;
}

/**
 * Makes a comparator and looks at the ground once. It tells what it would if it looked after each step, but looks only when it
 * is read: at the ground of the last step, and further back while that decides nothing.
 */
export function createLineComparator({ look, beforePaint }: LineView): LineComparator {
  let seen = look();
  let isBright = seen >= (DARK_BELOW + LIGHT_ABOVE) / 2;
  let unseenSteps = 0;
  const catchUp = (): void => {
    if (unseenSteps === 0) return;
    seen = look(0);
    for (let [at, ago] = [seen, 0]; ; at = look(ago)) {
      if (at > LIGHT_ABOVE || at < DARK_BELOW) {
        isBright = at > LIGHT_ABOVE;
        break;
      }
      if (++ago === unseenSteps) break;
    }
    unseenSteps = 0;
  };
  const stop = beforePaint?.(catchUp) ?? (() => undefined);
  return {
    sample: () => {
      if (++unseenSteps === MOST_STEPS_BACK) catchUp();
    },
    isBright: () => {
      catchUp();
      return isBright;
    },
    reflectance: () => {
      catchUp();
      return seen;
    },
    stop,
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
 * world; between two steps the wire holds what the last one gave, however often the program reads. It looks when the wire is
 * read, or after each step where something listens to the wire.
 */
export function attachLineSensor(wire: Wire, view: LineView): LineSensor {
  const output = wire.connect('line sensor');
  const comparator = createLineComparator(view);
  const level = (): Level => (comparator.isBright() ? 1 : 0);
  output.drive(level());
  return {
    sample: () => {
      comparator.sample();
      output.driveLate(level);
    },
    isBright: () => comparator.isBright(),
    stop: () => {
      comparator.stop();
      output.detach();
    },
  };
}
