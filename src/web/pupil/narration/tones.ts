import type { Moment } from './moment';

/** The tones of a moment; `null`: none. */
export interface Tones {
  /** Beeps, as those of a car that parks: the nearer something is ahead, the faster and the higher. */
  readonly beat: { readonly everyMs: number; readonly hz: number } | null;
  /** A soft lasting tone while sensors are on the line. `pan`: −1 left … 1 right. */
  readonly line: { readonly hz: number; readonly pan: number } | null;
}

export const silence: Tones = { beat: null, line: null };

/**
 * Distances in mm: nearer than the first something ahead is heard, nearer than the second the beeps do not change any
 * more.
 */
const FAR_MM = 500;
const NEAR_MM = 50;
/**
 * Intervals of the beeps, in ms. Chosen: one beep in a second says that something is there; eight can still be told
 * from one tone.
 */
const EVERY_MS = { far: 1000, near: 120 };
const BEAT_HZ = { far: 700, near: 1400 };
/**
 * Pitch of the line at the left and at the right. Chosen: left is deeper, so that it differs from right on a tablet
 * with one loudspeaker, too.
 */
const LINE_HZ = { left: 262, right: 392 };

/** The tones of a moment. */
export const tonesOf = (moment: Moment): Tones => ({ beat: beatOf(moment), line: lineOf(moment) });

function beatOf({ ahead }: Moment): Tones['beat'] {
  if (ahead === undefined || ahead === null || ahead.mm > FAR_MM) return null;
  const nearness = Math.min(1, (FAR_MM - ahead.mm) / (FAR_MM - NEAR_MM));
  return { everyMs: between(EVERY_MS.far, EVERY_MS.near, nearness), hz: between(BEAT_HZ.far, BEAT_HZ.near, nearness) };
}

/** The tone for the middle of the sensors that are on the line. */
function lineOf({ lineSensors }: Moment): Tones['line'] {
  const places = lineSensors.flatMap(({ isDark }, i) => (isDark ? [i] : []));
  if (places.length === 0) return null;
  const middle = places.reduce((sum, place) => sum + place, 0) / places.length;
  const share = lineSensors.length === 1 ? 0.5 : middle / (lineSensors.length - 1);
  return { hz: between(LINE_HZ.left, LINE_HZ.right, share), pan: 2 * share - 1 };
}

const between = (from: number, to: number, share: number): number => Math.round(from + (to - from) * share);
