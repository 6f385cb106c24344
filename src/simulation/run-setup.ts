import type { OptionValues } from '#core/option';
import type { Traits } from '#robots/traits';
import type { RobotStart, Scene } from '#scene/scene';
import type { InputEvent } from './input';

/** Stands for the bare board in places where a robot can be named. */
export const NO_ROBOT = 'none';

/** The most microcomputers of a run. Chosen: pupils work in pairs, and eight real times fit on a tablet. */
export const MOST_DEVICES = 8;

/** A microcomputer of a run, with a robot or without. */
export interface DeviceSetup {
  /** Unlike the others of the run; inputs and reports name the device by it. */
  readonly name: string;
  /** The files on the board by name; `main.py` is the program. */
  readonly files: Readonly<Record<string, string>>;
  /**
   * Id of a robot type, `none` for the bare board, or `auto`: the scene's, else the first that fits the board. A guess by
   * the program's imports (`chooseHardware`) is made before there is a set-up: a run does not depend on a source.
   */
  readonly robot: string;
  /** Id of a board type, or `auto`: the scene's, else the robot's. */
  readonly board: string;
  /** Id of a firmware of the board; left out: the board's first. */
  readonly firmware?: string;
  /** Chosen options of the robot: id of an option → id of a choice. They win over those of the scene. */
  readonly robotOptions?: OptionValues;
  /** The measured traits of this robot, which replace the faults that the seed would give it. Left out: none. */
  readonly traits?: Traits;
  /** The start of its robot; left out: the course's, see `starts.ts`. */
  readonly start?: RobotStart;
}

/** Everything a run depends on: the same set-up gives the same run, bit for bit, on every machine. Plain data. */
export interface RunSetup {
  readonly scene: Scene;
  /** One to eight, in the order in which they run between two steps of the world. */
  readonly devices: readonly [DeviceSetup, ...DeviceSetup[]];
  /** When the REPL greets after the program's end: `at-once` as on the device, or (the default) with the first byte typed. */
  readonly repl?: 'at-once' | 'when-typed';
  /** Whole number from which all random numbers are drawn. */
  readonly seed: number;
  /** 0 = ideal … 1 = like a used school robot: see `reality.ts`. */
  readonly reality: number;
  /** A log to replay: each action takes effect at the first step of the world at or after its time. */
  readonly inputs?: readonly InputEvent[];
  /** Keeps every row of the trace in memory (about 3 kB per simulated second). The hash is there either way. */
  readonly keepTrace?: boolean;
}

/** A run of one device, which needs no name of its own. */
export type SoloSetup = Omit<RunSetup, 'devices'> & Omit<DeviceSetup, 'name' | 'start'>;

/** Name of the device of a run that has only one. */
export const SOLO = '1';

/** The set-up of a run of one device. */
export function soloRun({ files, robot, board, firmware, robotOptions, traits, ...run }: SoloSetup): RunSetup {
  const options = { ...(firmware !== undefined && { firmware }), ...(robotOptions && { robotOptions }) };
  return { ...run, devices: [{ name: SOLO, files, robot, board, ...options, ...(traits && { traits }) }] };
}
