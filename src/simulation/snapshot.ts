import type { Pose } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import type { GamepadState } from '#devices/gamepad';
import type { LedChain } from '#devices/led-chains';
import type { SentKey } from '#devices/nec-remote';
import type { RobotLights, RobotState } from '#robots/robot';
import type { Position } from '#vm/debug/frames';
import type { Verdict } from './task/verdict';

/** The board at one moment. */
export interface BoardSnapshot {
  /** Id of its type. */
  readonly board: string;
  /** 25 levels 0 … 9, row by row. */
  readonly display: readonly number[];
  readonly buttons: { readonly a: boolean; readonly b: boolean };
  /** For each touch pad, by its sensor id (`pinLogo`): true if it is touched. */
  readonly touch: Readonly<Record<string, boolean>>;
  /** The colour LEDs on the board itself, 0 … 255 each; none on a micro:bit. */
  readonly rgb: readonly Rgb[];
  /** Duty of the board's own motor outputs, −1 … 1; none on a micro:bit. */
  readonly motors: readonly number[];
  /** The light beside the microphone. */
  readonly microphoneOn: boolean;
  /** The present value of every sensor, by its id. */
  readonly sensors: Readonly<Record<string, number | string>>;
  /** Range of each axis of the accelerometer in both directions, in mg: 2000, or as the program has set it. */
  readonly accelerometerRangeMg: number;
  /** The level down from which the microphone reports quiet, and the level from which it reports loud, 0 … 255. */
  readonly soundThresholds: { readonly quiet: number; readonly loud: number };
  readonly power: 'on' | 'asleep' | 'off';
  readonly radio: { readonly on: boolean; readonly group: number; readonly channel: number };
  /** True if the data log is full. */
  readonly logFull: boolean;
  /** The present tone of music, or `null` for silence. */
  readonly sound: { readonly hz: number } | null;
  /** Whether anything sounds: music, a sound effect, samples or speech. */
  readonly isSounding: boolean;
}

/** One device at one moment: its board, its program and its robot. */
export interface DeviceSnapshot extends BoardSnapshot {
  /** As the set-up names it. */
  readonly name: string;
  /** `program` until its end, then `world`, in which the REPL waits. */
  readonly running: 'program' | 'world';
  /** True while the program waits in `input()` for a line. */
  readonly awaitsInput: boolean;
  /** True once the REPL has greeted: it then receives the input. */
  readonly repl: boolean;
  /** Position of the program: the running line of the pupil's files, or the one that called what runs; `null`: none. */
  readonly position: Position | null;
  /** `null` for the bare board. */
  readonly robot: RobotSnapshot | null;
  /** Chains of ws2812 lights on pins where no robot has its own, in the order of the pins. */
  readonly lights: readonly LedChain[];
  /** True if the board measures the arena: see the action `arena-senses`. */
  readonly arenaSenses: boolean;
  /** The key of the remote control that was sent last; left out before the first. */
  readonly infrared?: SentKey;
  /** Left out for a board that is plugged into no gamepad. */
  readonly gamepad?: GamepadState;
}

/** The whole run at one moment, as plain data: to be drawn, reported and sent. It begins with the first device. */
export interface Snapshot extends DeviceSnapshot {
  /** Simulated time. */
  readonly timeUs: number;
  /** The devices after the first. */
  readonly others: readonly DeviceSnapshot[];
  /** Poses of the movable blocks, by object id. */
  readonly blocks: Readonly<Record<string, Pose>>;
  /** Poses of the moving obstacles, by object id. */
  readonly movers: Readonly<Record<string, Pose>>;
  /** By object id: which lamps shine and which barriers are open; left out in a course without any. */
  readonly switched?: Readonly<Record<string, boolean>>;
  /** How well the task is done, or `null` if the course has no task. */
  readonly verdict: Verdict | null;
}

/** The lights of a device and its robot. */
export interface Lights extends Pick<DeviceSnapshot, 'rgb' | 'lights'> {
  /** `null` for the bare board. */
  readonly robot: RobotLights | null;
}

/** The robot at one moment. */
export interface RobotSnapshot {
  /** Id of its type. */
  readonly type: string;
  readonly scale: number;
  readonly pose: Pose;
  /** Rotation of the left and the right wheel since the start. */
  readonly wheelTurnRad: readonly [number, number];
  readonly state: RobotState;
  /** Touches of walls and blocks since the start. */
  readonly collisions: number;
  /** Length of the path since the start. */
  readonly pathMm: number;
  /** Rotation since the start, counter-clockwise positive, not wrapped. */
  readonly turnedRad: number;
}
