/** Commands on a program's lines and a run's time: the part of the port that a debugger uses. */
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';

import type { Refusal } from './refusal';

export type { BreakPoint, LineStep } from '#vm/debug/stops';

/** A step by lines, or back to the line that began before. */
export type HostStep = LineStep | 'back';

/** The place of a program, and its variables. */
export interface ProgramMoment {
  /** In µs of the device's clock. */
  readonly timeUs: number;
  readonly variables: Variables;
}

/**
 * Stops, steps, variables and the past. None of it changes how a run comes out. A name of a device that is left out
 * means the first. Wrong values are refused, never thrown.
 */
export interface EmbeddedDebugger {
  /** The break points of a device's program, by file and line, or why there are none. */
  breakPoints(device?: string): readonly BreakPoint[] | string;
  /** Replaces the break points of a device's program. */
  setBreakPoints(points: readonly BreakPoint[], device?: string): Promise<Refusal>;
  /** The place of a program: at the moment that is looked at, else now. A text: the reason why it is unknown. */
  moment(device?: string): Promise<ProgramMoment | string>;
  /**
   * Lets a program that stands make a step; resolves when it is under way. Back, and from a moment of the past on, it
   * resolves when the line is shown.
   */
  step(step: HostStep, device?: string): Promise<Refusal>;
  /** Pauses the run and shows a moment that it has been through, in simulated µs. */
  lookAt(timeUs: number): Promise<Refusal>;
  /** Shows the present again; the run stays paused. */
  lookNow(): Refusal;
  /** Lets the run go on from the moment that is looked at; resolves when it is there. What came after is gone. */
  goOn(paused: boolean): Promise<Refusal>;
  /** True if a moment of the past is looked at. */
  isLookingBack(): boolean;
}
