import type { Pose } from '#core/geometry';
import type { RobotState } from '#robots/robot';

/** The whole run at one moment, as plain data: what is drawn, told and sent. */
export interface Snapshot {
  /** Simulated time. */
  readonly timeUs: number;
  /** Whose time it is: the program's, or the world's after the program has ended. */
  readonly running: 'program' | 'world';
  /** 25 levels 0 … 9, row by row. */
  readonly display: readonly number[];
  readonly buttons: { readonly a: boolean; readonly b: boolean };
  /** Whether a finger is on each touch pad, by its name. */
  readonly touch: Readonly<Record<string, boolean>>;
  /** `null` for the bare board. */
  readonly robot: RobotSnapshot | null;
  /** Where the movable blocks are, by object id. */
  readonly blocks: Readonly<Record<string, Pose>>;
  /** The tone that sounds, or `null` for silence. */
  readonly sound: { readonly hz: number } | null;
}

/** The robot at one moment. */
export interface RobotSnapshot {
  /** Id of its type. */
  readonly type: string;
  readonly scale: number;
  readonly pose: Pose;
  /** How far the left and the right wheel have turned since the start. */
  readonly wheelTurnRad: readonly [number, number];
  readonly state: RobotState;
  /** Touches of walls and blocks since the start. */
  readonly collisions: number;
  /** Length of the way since the start. */
  readonly pathMm: number;
  /** Turned since the start, counter-clockwise positive, not wrapped. */
  readonly turnedRad: number;
}
