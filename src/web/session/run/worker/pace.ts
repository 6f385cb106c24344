import type { Speed } from '#simulation/pace';
import { dueUs, withoutBacklog, type Anchor } from './pacing';
import { STEP_PRESS_US, type ToWorker } from './protocol';

/** The messages that change the pace of a run. */
export type PaceMessage = Extract<ToWorker, { type: 'pause' | 'resume' | 'step' | 'step-line' | 'speed' }>;

/**
 * The pace of a run: how far it may go by now, by the wall clock times the speed, a pause, or the moment to catch up
 * with.
 */
export class Pace {
  paused = false;
  speed: Speed = 1;
  private stepUntilUs = 0;
  /** Until this simulated time neither pause nor pace counts. */
  private catchUpUs = 0;
  private anchor: Anchor = { wallMs: 0, simulatedUs: 0, speed: 1 };

  begin({ paused, speed, catchUpUs }: Extract<ToWorker, { type: 'run' }>): void {
    this.paused = paused;
    this.speed = speed;
    this.catchUpUs = catchUpUs ?? 0;
  }

  change(message: PaceMessage, nowUs: number): void {
    switch (message.type) {
      case 'pause':
        this.paused = true;
        this.stepUntilUs = nowUs;
        break;
      case 'resume':
      case 'step-line':
        this.paused = false;
        break;
      case 'step':
        this.paused = true;
        this.stepUntilUs = Math.max(this.stepUntilUs, nowUs) + STEP_PRESS_US;
        break;
      case 'speed':
        this.speed = message.speed;
        break;
      default:
        message satisfies never;
    }
  }

  get isCatchingUp(): boolean {
    return this.catchUpUs > 0;
  }

  /** The run goes as fast as possible. */
  get isUnbound(): boolean {
    return this.isCatchingUp || (!this.paused && this.anchor.speed === 'max');
  }

  /**
   * Ends catching up if the run has reached its target: from here on it goes at its pace. @returns whether it has just
   * arrived
   */
  endCatchingUp(nowUs: number): boolean {
    if (!this.isCatchingUp || nowUs < this.catchUpUs) return false;
    this.catchUpUs = 0;
    this.stepUntilUs = nowUs;
    return true;
  }

  /** Simulated time that a run may reach now. */
  limitUs(nowUs: number, wallMs: number): number {
    if (nowUs < this.catchUpUs) return this.catchUpUs;
    return this.paused ? this.stepUntilUs : dueUs(this.anchor, wallMs);
  }

  /**
   * Ties simulated time to the wall clock here. At full speed a world whose programs have ended would run hours ahead,
   * so it continues in real time.
   */
  anchorAt(wallMs: number, simulatedUs: number, hasEnded: boolean): void {
    this.anchor = { wallMs, simulatedUs, speed: this.speed === 'max' && hasEnded ? 1 : this.speed };
  }

  /** A machine that has fallen behind for good continues from here. */
  forgetBacklog(wallMs: number, simulatedUs: number): void {
    this.anchor = withoutBacklog(this.anchor, wallMs, simulatedUs);
  }
}
