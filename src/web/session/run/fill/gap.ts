import type { Recording } from '../recording';

/** A stretch of a run, after the first time and up to the second, of which moments are missing on its tape. */
export interface Gap {
  readonly sinceUs: number;
  readonly untilUs: number;
}

/** The moments that are missing on a tape, as far as the run can be run again for them; `null`: none are. */
export function gapIn({ reported, thinSince }: Recording): Gap | null {
  const place = thinSince.findIndex((since) => since !== null);
  const sinceUs = thinSince[place] ?? null;
  return sinceUs === null || place >= reported.pieces ? null : { sinceUs, untilUs: reported.untilUs };
}

/** Replaces the existing moments of a gap by all of its moments. @param pieces they depend on none before them */
export function fillGap(recording: Recording, { sinceUs, untilUs }: Gap, pieces: readonly Uint8Array[]): void {
  const { reported, thinSince } = recording;
  const gap = gapIn(recording);
  if (gap?.sinceUs !== sinceUs || gap.untilUs !== untilUs) return; // the run has gone on
  const place = thinSince.findIndex((since) => since !== null);
  recording.pieces = [...recording.pieces.slice(0, place), ...pieces, ...recording.pieces.slice(reported.pieces)];
  recording.thinSince = [...thinSince.slice(0, place), ...pieces.map(() => null), ...thinSince.slice(reported.pieces)];
  recording.reported = { pieces: place + pieces.length, untilUs };
  recording.count.value += 1;
}
