/**
 * A robot of one's own: measured with a ruler after three short programs (`programs/`), and the traits that were fitted
 * to that (`fit.ts`). Lengths in mm, angles in degrees, to the left positive.
 */
import { traitLimits, type LineReadings, type Traits } from '#robots/traits';
import { shown } from '#scene/problem';
import type { Reader } from '#scene/reader';

/** Position of the robot's nose after a drive straight ahead, relative to its pose before. */
export interface Drive {
  readonly aheadMm: number;
  readonly leftMm: number;
}

/** The drives straight ahead, in the order of the program: slowly, as usual, fast. */
export const DRIVES = ['slow', 'usual', 'fast'] as const;
export type DriveName = (typeof DRIVES)[number];

/** True distances from the ultrasonic sensor at which its reading is asked for, in mm. */
export const ECHOES_MM = [100, 400] as const;

/** The measurements; `null` and sensors left out: not measured. */
export interface Measured {
  readonly drives: Readonly<Record<DriveName, Drive | null>>;
  /** Total turn to the left, in degrees: two turns are 720. */
  readonly turnDeg: number | null;
  /** Readings of the ultrasonic sensor at each of `ECHOES_MM`, in mm. */
  readonly echoesMm: readonly [number | null, number | null];
  /** Readings of the line sensors on black and on white paper, by the sensor's name. */
  readonly line: Readonly<Record<string, LineReadings>>;
}

/** A robot of one's own. */
export interface MyRobot {
  readonly name: string;
  /** Id of its type. */
  readonly robot: string;
  /** True if runs with a robot of its type use this one's traits. */
  readonly used: boolean;
  readonly measured: Measured;
  readonly traits: Traits;
}

/** Nothing measured yet. */
export const nothingMeasured: Measured = {
  drives: { slow: null, usual: null, fast: null },
  turnDeg: null,
  echoesMm: [null, null],
  line: {},
};

/** Bounds of what is measured. Chosen: beyond them it is a slip of the pen. */
export const myRobotLimits = {
  nameCharacters: 40,
  aheadMm: { min: 0, max: 3000 },
  leftMm: { min: -1500, max: 1500 },
  turnDeg: { min: 0, max: 3600 },
  echoMm: { min: 0, max: 5000 },
  sensors: 16,
  sensorCharacters: 20,
} as const;

/** Reads a robot out of an unchecked value; what is wrong is reported to the reader. */
export function readMyRobot(value: unknown, path: string, reader: Reader): MyRobot {
  const fields = reader.fields(value, path, ['name', 'robot', 'used', 'measured', 'traits']);
  return {
    name: reader.text(fields['name'], `${path}.name`, myRobotLimits.nameCharacters),
    robot: reader.text(fields['robot'], `${path}.robot`, 100),
    used: reader.flag(fields['used'], `${path}.used`, true),
    measured: readMeasured(fields['measured'], `${path}.measured`, reader),
    traits: readTraits(fields['traits'], `${path}.traits`, reader),
  };
}

function readMeasured(value: unknown, path: string, reader: Reader): Measured {
  const fields = reader.fields(value, path, ['drives', 'turnDeg', 'echoesMm', 'line']);
  const drives = reader.fields(fields['drives'], `${path}.drives`, DRIVES);
  const drive = (name: DriveName): Drive | null => {
    if (drives[name] === null) return null;
    const at = `${path}.drives.${name}`;
    const { aheadMm, leftMm } = reader.fields(drives[name], at, ['aheadMm', 'leftMm']);
    return {
      aheadMm: reader.number(aheadMm, `${at}.aheadMm`, myRobotLimits.aheadMm),
      leftMm: reader.number(leftMm, `${at}.leftMm`, myRobotLimits.leftMm),
    };
  };
  const orNull = (of: unknown, at: string, range: { readonly min: number; readonly max: number }): number | null =>
    of === null ? null : reader.number(of, at, range);
  const [near, far] = reader.list(fields['echoesMm'], `${path}.echoesMm`, { min: 2, max: 2 });
  return {
    drives: { slow: drive('slow'), usual: drive('usual'), fast: drive('fast') },
    turnDeg: orNull(fields['turnDeg'], `${path}.turnDeg`, myRobotLimits.turnDeg),
    echoesMm: [
      orNull(near, `${path}.echoesMm[0]`, myRobotLimits.echoMm),
      orNull(far, `${path}.echoesMm[1]`, myRobotLimits.echoMm),
    ],
    line: readLine(fields['line'], `${path}.line`, reader),
  };
}

function readTraits(value: unknown, path: string, reader: Reader): Traits {
  const fields = reader.fields(value, path, ['motors', 'ultrasonic', 'line']);
  const motors = reader.fields(fields['motors'], `${path}.motors`, ['difference', 'charge', 'sag', 'friction']);
  const ultrasonic = reader.fields(fields['ultrasonic'], `${path}.ultrasonic`, ['offsetMm', 'scale']);
  const motor = (key: 'difference' | 'charge' | 'sag' | 'friction'): number =>
    reader.number(motors[key], `${path}.motors.${key}`, traitLimits[key]);
  const sonic = (key: 'offsetMm' | 'scale'): number =>
    reader.number(ultrasonic[key], `${path}.ultrasonic.${key}`, traitLimits[key]);
  return {
    motors: {
      difference: motor('difference'),
      charge: motor('charge'),
      sag: motor('sag'),
      friction: motor('friction'),
    },
    ultrasonic: { offsetMm: sonic('offsetMm'), scale: sonic('scale') },
    line: readLine(fields['line'], `${path}.line`, reader),
  };
}

function readLine(value: unknown, path: string, reader: Reader): Readonly<Record<string, LineReadings>> {
  const names = typeof value === 'object' && value !== null ? Object.keys(value) : [];
  const fields = reader.fields(value, path, names);
  reader.list(names, path, { min: 0, max: myRobotLimits.sensors });
  const read = names.slice(0, myRobotLimits.sensors).map((name): [string, LineReadings] => {
    if (name === '__proto__') reader.report('unknown-value', path, name, '"__proto__" cannot be a sensor.');
    const at = `${path}.${reader.text(name, path, myRobotLimits.sensorCharacters)}`;
    const { black, floor } = reader.fields(fields[name], at, ['black', 'floor']);
    const readings = {
      black: reader.number(black, `${at}.black`, traitLimits.reading),
      floor: reader.number(floor, `${at}.floor`, traitLimits.reading),
    };
    if (readings.black === readings.floor) {
      const what = `${shown(readings.black)} on black and on white alike: the sensor sees no difference.`;
      reader.report('unknown-value', at, readings.floor, what);
    }
    return [name, readings];
  });
  return Object.fromEntries(read);
}
