/**
 * The messages between the page and the worker that runs the simulation. Every message is plain data; every message the
 * page can send is a `ToWorker`, every one it can receive a `FromWorker`. One worker serves one run and is then thrown away.
 * A number `device` is the place of one in the run's set-up. On its way a `snapshot` is what has changed in it (`pictures.ts`).
 *
 *     page                                   worker
 *      │ prepare (compiled VM)  ───────────►  │
 *      │ ◄───────────────────────── prepared  │
 *      │ run (scene, files, options) ──────►  │
 *      │ ◄────────────────────────── started  │
 *      │ frame ────────────────────────────►  │   one per animation frame, answered when something moved
 *      │ ◄───────────────── snapshot · alive  │
 *      │ ◄────────────────── events · console │
 *      │ console-taken ────────────────────►  │   nothing more is sent before it: the program waits, the page never drowns
 *      │ stop ─────────────────────────────►  │
 *      │ ◄────────────────────────── stopped  │   or, after STOP_ANSWER_MS, the page ends the worker
 */
import type { InputAction, InputEvent } from '#simulation/input';
import type { Speed } from '#simulation/pace';
import type { RunSetup } from '#simulation/run-setup';
import type { Ended } from '#simulation/simulation';

import type { Snapshot } from '#simulation/snapshot';
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';
import type { RunEvents } from './event-box';
import type { Output } from './outbox';

export type { RunEvents } from './event-box';
export type { Output } from './outbox';

/** Simulated time of one press of *step*, in µs: 20 ms, one row of the trace. */
export const STEP_PRESS_US = 20_000;

/** From the page to the worker. */
export type ToWorker =
  /** First message: the compiled VM. A `WebAssembly.Module` is shared, not copied. */
  | { readonly type: 'prepare'; readonly firmware: WebAssembly.Module }
  /**
   * Starts the run. `paused` starts it paused. `catchUpUs`: until this simulated time it runs as fast as possible,
   * paused or not.
   */
  | {
      readonly type: 'run';
      readonly setup: RunSetup;
      readonly speed: Speed;
      readonly paused: boolean;
      readonly catchUpUs?: number;
    }
  /** Simulated time is paused until `resume` or `step`. */
  | { readonly type: 'pause' }
  | { readonly type: 'resume' }
  /** Lets `STEP_PRESS_US` of simulated time pass, then pauses again. */
  | { readonly type: 'step' }
  | { readonly type: 'speed'; readonly speed: Speed }
  /**
   * A button, the hand, a sensor, serial text: takes effect at the next step of the world. `device`: name of the one that
   * it is for; left out: the first, and of a packet all.
   */
  | { readonly type: 'input'; readonly action: InputAction; readonly device?: string }
  /** The page is ready to draw: the next change is answered by one `snapshot`. */
  | { readonly type: 'frame' }
  /** The last `console` batch has been processed. */
  | { readonly type: 'console-taken' }
  /** The page looks back: the newest moments of the tape are wanted now, not when their piece is full. */
  | { readonly type: 'tape' }
  /** The breakpoints of each device from now on, by its place. At one of them the run sends `held`. */
  | { readonly type: 'break-points'; readonly points: readonly (readonly BreakPoint[])[] }
  /** Runs until the device has made a step by lines, or until a breakpoint; then the run sends `held`. */
  | { readonly type: 'step-line'; readonly step: LineStep; readonly device: number }
  /** Requests the current variables of a device; answered by `variables`. */
  | { readonly type: 'inspect'; readonly device: number }
  /** KeyboardInterrupt in the program, a moment for its `finally`, then the end. */
  | { readonly type: 'stop' };

/** From the worker to the page. */
export type FromWorker =
  /** The VM is loaded; `run` will start immediately. */
  | { readonly type: 'prepared' }
  | { readonly type: 'started' }
  /** `trails`: each device's robot's path since the last picture, x and y in mm alternately; two `NaN` where it was lifted. */
  | { readonly type: 'snapshot'; readonly snapshot: Snapshot; readonly trails: readonly (readonly number[])[] }
  /** Heartbeat, about ten a second while time runs: simulated time and the factor reached lately (simulated s per wall s). */
  | { readonly type: 'alive'; readonly nowUs: number; readonly achieved: number | null }
  /** Nothing happens any more until the next input: simulated time is paused, and there is no heartbeat. */
  | { readonly type: 'resting' }
  /** Sounds, radio packets and log rows of a device since its last such message; about once a frame. */
  | { readonly type: 'events'; readonly events: RunEvents; readonly device: number }
  /**
   * The pictures of the run, 50 moments for a second of simulated time: a piece for `Rows`, in their order.
   * `thinSinceUs`: it has one moment for two seconds, since the run went as fast as possible, and those after this time
   * are missing.
   */
  | { readonly type: 'tape'; readonly piece: Uint8Array; readonly thinSinceUs: number | null }
  /** All inputs to the run up to this time; answers `tape`, and is sent when the programs end and before `stopped`. */
  | { readonly type: 'inputs'; readonly inputs: readonly InputEvent[]; readonly nowUs: number }
  /** A break point or a step of this device has stopped the run, at this time of its clock; it is paused, after a `snapshot`. */
  | { readonly type: 'held'; readonly device: number; readonly timeUs: number }
  /** Stack and variables of a device as they are now, at this time of its clock. */
  | { readonly type: 'variables'; readonly device: number; readonly timeUs: number; readonly variables: Variables }
  /** Output of the programs, oldest first; at most one batch in transit. */
  | { readonly type: 'console'; readonly output: readonly Output[] }
  /** A program is over; the world and the REPL keep running until `stop`. Sent after all of the program's output. */
  | { readonly type: 'program-ended'; readonly ended: Ended; readonly device: number }
  /** The program runs again from its start: Ctrl-D at the REPL. */
  | { readonly type: 'program-restarted'; readonly device: number }
  /** The run is over; all output has been sent. The worker does nothing more. */
  | { readonly type: 'stopped' }
  /**
   * An `input` that this run rejects, such as one for a block that does not exist: it is ignored, the run continues.
   */
  | { readonly type: 'refused'; readonly message: string }
  /** The run could not start or broke inside (our fault, not the program's). */
  | { readonly type: 'failed'; readonly message: string };
