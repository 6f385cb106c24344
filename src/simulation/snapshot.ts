import type { Pose } from '#core/geometry';
import type { RobotState } from '#robots/robot';
import type { Verdict } from './verdict';

/** The board at one moment. */
export interface BoardSnapshot {
  /** Id of its type. */
  readonly board: string;
  /** 25 levels 0 … 9, row by row. */
  readonly display: readonly number[];
  readonly buttons: { readonly a: boolean; readonly b: boolean };
  /** Whether a finger is on each touch pad, by its name. */
  readonly touch: Readonly<Record<string, boolean>>;
  /** The colour LEDs on the board itself, 0 … 255 each; none on a micro:bit. */
  readonly rgb: readonly (readonly [number, number, number])[];
  /** Duty of the board's own motor outputs, −1 … 1; none on a micro:bit. */
  readonly motors: readonly number[];
  /** The light beside the microphone. */
  readonly microphoneOn: boolean;
  /** What every sensor feels now, by its id. */
  readonly sensors: Readonly<Record<string, number | string>>;
  /** How far each axis of the accelerometer reaches either way, in mg: 2000, or as the program has set it. */
  readonly accelerometerRangeMg: number;
  /** From which level down the microphone calls it quiet and from which on loud, 0 … 255. */
  readonly soundThresholds: { readonly quiet: number; readonly loud: number };
  readonly power: 'on' | 'asleep' | 'off';
  readonly radio: { readonly on: boolean; readonly group: number; readonly channel: number };
  /** Nothing more fits into the data log. */
  readonly logFull: boolean;
  /** The tone that music makes, or `null` for silence. */
  readonly sound: { readonly hz: number } | null;
  /** Whether anything sounds: music, a sound effect, samples or speech. */
  readonly isSounding: boolean;
}

/** The whole run at one moment, as plain data: what is drawn, told and sent. */
export interface Snapshot extends BoardSnapshot {
  /** Simulated time. */
  readonly timeUs: number;
  /** Whose time it is: the program's, or after its end the world's, in which the REPL waits. */
  readonly running: 'program' | 'world';
  /** The REPL has greeted: what is typed is its. */
  readonly repl: boolean;
  /** `null` for the bare board. */
  readonly robot: RobotSnapshot | null;
  /** Where the movable blocks are, by object id. */
  readonly blocks: Readonly<Record<string, Pose>>;
  /** Where the moving obstacles are, by object id. */
  readonly movers: Readonly<Record<string, Pose>>;
  /** How well the task is done, or `null` where the course sets none. */
  readonly verdict: Verdict | null;
  /** Chains of ws2812 lights on pins where no robot has its own, in the order of the pins. */
  readonly lights: readonly LightChain[];
  /** Whether the board feels the arena: see the action `arena-senses`. */
  readonly arenaSenses: boolean;
}

/** A chain of colour lights on a pin, the light next to the pin first; red, green, blue 0 … 255. */
export interface LightChain {
  readonly pin: string;
  readonly colors: readonly (readonly [number, number, number])[];
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
