import type { SoundEvent } from '#board/sound/sound-event';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';
import type { Reason } from '../result';

/** What a watcher says about its check at some moment of the run. */
export interface Standing {
  /**
   * `open`: not reached yet. `held`: nothing speaks against it so far. `met`, `failed`: for good.
   */
  readonly state: 'open' | 'held' | 'met' | 'failed';
  /** Simulated time of the decision, or `null`. */
  readonly atUs: number | null;
}

/** The run now, as far as it costs nothing to look at. */
export interface Glance {
  readonly timeUs: number;
  readonly verdict: Verdict | null;
  /** Touches up to now, also after the goals of the course are reached. */
  readonly touches: number;
  /** When all that is needed was reached; `null`: it is not yet. */
  readonly reachedUs: number | null;
}

/** Looks at a run for one check. What it has no function for, nobody makes. */
export interface Watcher {
  standing(): Standing;
  /** Why the check does not hold, asked at the end of the run. */
  reason(): Reason;
  /** Ten times a second of simulated time. */
  glance?(glance: Glance): void;
  /** What the run shows, 50 times a second. */
  moment?(snapshot: Snapshot): void;
  /** What the first device's program prints. */
  print?(text: string, timeUs: number): void;
  sound?(event: SoundEvent): void;
  radio?(packet: RadioPacket): void;
  log?(event: TimedLogEvent): void;
}

/** Not reached yet. */
export const OPEN: Standing = { state: 'open', atUs: null };
/** Nothing speaks against it so far. */
export const HELD: Standing = { state: 'held', atUs: null };
/** Reached. */
export const metAt = (atUs: number): Standing => ({ state: 'met', atUs });
/** Missed for good. */
export const failedAt = (atUs: number): Standing => ({ state: 'failed', atUs });
