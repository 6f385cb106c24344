import type { RobotOutput } from '#robots/robot';

/**
 * The outputs of a device that a program sets: of its robot, of its board (`motor-0` is the first of the board's own motor
 * connectors), a pin by the name of its wire, or a chain of lights that is plugged in there.
 */
export type Output =
  | RobotOutput
  | 'display'
  | 'sound'
  | 'board-lights'
  | 'radio'
  | 'log'
  | 'console'
  | `motor-${number}`
  | `chain-${string}`
  | `pin-${string}`;

/** A line of the pupil's files. */
export interface CodeLine {
  readonly file: string;
  readonly line: number;
}

/** A report that a program sets an output, maybe to the value that it already has. */
export interface OutputSet {
  readonly output: Output;
  /** In µs of the device's clock. */
  readonly timeUs: number;
  /** The value it is set to; `null`: it is an event, and each one counts. */
  readonly value: string | number | null;
  /** The lines that do it, innermost first: one for each of the pupil's functions that run. Empty: it was typed. */
  readonly lines: readonly CodeLine[];
}
