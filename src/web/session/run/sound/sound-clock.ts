/**
 * Delay between a sound's arrival and its playing, in s. Chosen: events arrive once a frame and the audio thread looks
 * ahead some ms; with less, notes are late, with more, the sound lags behind the lights.
 */
export const LATENCY_S = 0.08;
/** A sound further ahead than this, in s, means that the clocks have drifted apart. */
const MOST_AHEAD_S = 0.3;
/** A sound later than this synchronises the clocks again, in s. Chosen: one that is less late is played immediately. */
const MOST_LATE_S = 0.02;

/** Ties simulated time to the time of the sound system. */
export interface SoundClock {
  /**
   * The moment for a sound of simulated time `timeUs`, in s of the sound system, never before `nowS`.
   *
   * The first one sounds `LATENCY_S` from now. From then on the distances are those of simulated time, to the ms, as
   * long as simulated time is on pace; after a pause or a stumble the clocks are synchronised again.
   *
   * @param speed simulated seconds per second
   */
  at(timeUs: number, nowS: number, speed: number): number;
  /** Forgets the synchronisation: the next sound counts as the first. */
  reset(): void;
}

/** Creates a clock that is not synchronised yet. */
export function createSoundClock(): SoundClock {
  let tie: { readonly timeUs: number; readonly atS: number; readonly speed: number } | null = null;
  return {
    at(timeUs, nowS, speed) {
      if (tie !== null) {
        const atS = tie.atS + (timeUs - tie.timeUs) / 1_000_000 / tie.speed;
        const isInTime = atS > nowS - MOST_LATE_S && atS < nowS + MOST_AHEAD_S;
        if (isInTime && tie.speed === speed) return Math.max(atS, nowS);
      }
      tie = { timeUs, atS: nowS + LATENCY_S, speed };
      return tie.atS;
    },
    reset() {
      tie = null;
    },
  };
}
