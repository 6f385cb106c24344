import { radOf } from '#core/angle';
import type { Pose } from '#core/geometry';
import type { GamepadKey } from '#devices/gamepad';
import type { RemoteKey } from '#devices/nec-remote';
import type { SceneEdit } from '#scene/edit';

/** A pose as people write it: degrees counter-clockwise from +x. */
export interface PlacedPose {
  readonly xMm: number;
  readonly yMm: number;
  readonly headingDeg: number;
}

/** An action on a run from outside. Plain data: it can be sent, logged and replayed. */
export type InputAction =
  | { readonly type: 'button'; readonly button: 'a' | 'b'; readonly down: boolean }
  /** A finger on `pinLogo`, `pin0`, … */
  | { readonly type: 'touch'; readonly pad: string; readonly down: boolean }
  /** The infrared remote control, pointed at a robot; without a device at all of them. */
  | { readonly type: 'remote'; readonly key: RemoteKey; readonly down: boolean }
  /** The stick of a gamepad is moved, −1 … 1; right and up are positive. */
  | { readonly type: 'stick'; readonly x: number; readonly y: number }
  | { readonly type: 'gamepad'; readonly key: GamepadKey; readonly down: boolean }
  /** Text typed into the console. */
  | { readonly type: 'serial'; readonly text: string }
  /** The value of a sensor of the board: `lightLevel`, `temperature`, `accelerometerX`, … */
  | { readonly type: 'sensor'; readonly id: string; readonly value: number | string }
  /** The hand tool puts the robot somewhere; it stands still there. */
  | { readonly type: 'place'; readonly pose: PlacedPose }
  /** The hand tool puts the block of this object id somewhere. */
  | { readonly type: 'place-block'; readonly id: string; readonly pose: PlacedPose }
  /** The hand switches a lamp on or off, or opens or closes a barrier: one that is switched by hand. */
  | { readonly type: 'switch'; readonly id: string; readonly on: boolean }
  /** A packet arrives by radio: a text as `radio.send` of another board sends it, or the bytes of `radio.send_bytes`. */
  | { readonly type: 'radio'; readonly text: string }
  | { readonly type: 'radio'; readonly bytes: readonly number[] }
  /** Whether the board on the robot measures the arena (compass, accelerometer, light) or takes values set by hand. */
  | { readonly type: 'arena-senses'; readonly on: boolean }
  /** The course is changed during a run; `at-once.ts` says what shows at once and what only in the next run. */
  | { readonly type: 'edit'; readonly edit: SceneEdit }
  /** A lack of progress is called on a scored line: the robot begins anew at the last checkpoint. */
  | { readonly type: 'no-progress' }
  /** KeyboardInterrupt in the program. */
  | { readonly type: 'interrupt' };

/** An action and the simulated time at which it takes effect. */
export interface InputEvent {
  readonly timeUs: number;
  /**
   * Name of the device that it is for; left out: the first. A packet or the remote control without a name reaches all of
   * them.
   */
  readonly device?: string;
  readonly action: InputAction;
}

/** A pose as the world has it. */
export const poseOf = ({ xMm, yMm, headingDeg }: PlacedPose): Pose => ({ xMm, yMm, headingRad: radOf(headingDeg) });

/** True for what reaches all devices unless it names one: what comes through the air. */
export const reachesAll = ({ type }: InputAction): boolean => type === 'radio' || type === 'remote';
