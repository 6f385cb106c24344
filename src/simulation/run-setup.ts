import type { OptionValues } from '#core/option';
import type { Traits } from '#robots/traits';
import type { Scene } from '#scene/scene';
import type { InputEvent } from './input';

/** Everything a run depends on: the same set-up gives the same run, bit for bit, on every machine. Plain data. */
export interface RunSetup {
  readonly scene: Scene;
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
  /** When the REPL greets after the program's end: `at-once` as on the device, or (the default) with the first byte typed. */
  readonly repl?: 'at-once' | 'when-typed';
  /** Whole number from which all random numbers are drawn. */
  readonly seed: number;
  /** Chosen options of the robot: id of an option → id of a choice. They win over those of the scene. */
  readonly robotOptions?: OptionValues;
  /** 0 = ideal … 1 = like a used school robot: see `reality.ts`. */
  readonly reality: number;
  /** What was measured of this robot; it takes the place of the faults that the seed would give it. Left out: nothing. */
  readonly traits?: Traits;
  /** A log to replay: each action takes effect at the first step of the world at or after its time. */
  readonly inputs?: readonly InputEvent[];
  /** Keeps every row of the trace in memory (about 3 kB per simulated second). The hash is there either way. */
  readonly keepTrace?: boolean;
}
