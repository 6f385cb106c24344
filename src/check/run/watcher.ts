import type { SoundEvent } from '#board/sound/sound-event';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { Simulation } from '#simulation/simulation';
import type { Reason } from '../result';

/** State of a check at some moment of the run. */
export interface Standing {
  /** `open`: not reached yet. `held`: not violated so far. `met`, `failed`: for good. */
  readonly state: 'open' | 'held' | 'met' | 'failed';
  /** Simulated time of the decision, or `null`. */
  readonly atUs: number | null;
}

/** The run at a step of the world, after its judge has looked. Each property is computed when it is read. */
export type Step = Pick<
  Simulation,
  'nowUs' | 'pose' | 'body' | 'blockLying' | 'verdict' | 'isJudged' | 'touches' | 'display' | 'lights'
>;

/** Watches a run for one check. Events without a handler are not produced. */
export interface Watcher {
  standing(): Standing;
  /** Why the check does not hold, asked at the end of the run. */
  reason(): Reason;
  /** Number of those reached, of a check that gives points for each. */
  count?(): number;
  /** Every step of the world, as the judge of the course sees it. */
  step?(run: Step): void;
  /** After the last step that counts. */
  end?(run: Step): void;
  /** After all others have looked at a step. @param reachedUs when all that is needed was reached; `null`: it is not yet */
  clock?(nowUs: number, reachedUs: number | null): void;
  /** Receives the output of the first device's program. */
  print?(text: string, timeUs: number): void;
  sound?(event: SoundEvent): void;
  radio?(packet: RadioPacket): void;
  log?(event: TimedLogEvent): void;
}

/** Not reached yet. */
export const OPEN: Standing = { state: 'open', atUs: null };
/** Not violated so far. */
export const HELD: Standing = { state: 'held', atUs: null };
/** Reached. */
export const metAt = (atUs: number): Standing => ({ state: 'met', atUs });
/** Missed for good. */
export const failedAt = (atUs: number): Standing => ({ state: 'failed', atUs });
