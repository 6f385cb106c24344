import type { Verdict } from '#simulation/task/verdict';

/** A stretch of a run's time, in simulated µs: from its first to its last moment. */
export interface Stretch {
  readonly fromUs: number;
  readonly toUs: number;
}

/** Number of pictures in a strip. Chosen: fewer tell nothing, more are too small on A4. */
export const PICTURES = { least: 4, usual: 6, most: 12 } as const;

/** One moment of the tape. */
const MOMENT_US = 20_000;

/** The moments of a strip: evenly spread, the first and the last of the stretch among them. */
export function stripTimes({ fromUs, toUs }: Stretch, count: number): readonly number[] {
  return Array.from({ length: count }, (_, at) => {
    const timeUs = fromUs + ((toUs - fromUs) * at) / Math.max(1, count - 1);
    return Math.round(timeUs / MOMENT_US) * MOMENT_US;
  });
}

/** The columns and rows of a strip: as full as can be, and the pictures not too small. */
export function stripForm(count: number): { readonly columns: number; readonly rows: number } {
  const columns = [5, 6, 9].includes(count) ? 3 : 4;
  return { columns, rows: Math.ceil(count / columns) };
}

/** Time from one picture of a film to the next. A GIF counts in 10 ms; browsers show none below 20 ms. Chosen: 12.5 a second. */
export const FRAME_US = 80_000;

/** Longest film. Chosen: some 400 pictures, 5 MB, made in half a minute on a weak tablet. */
export const LONGEST_FILM_US = 30_000_000;

/** The moments of a film: one every 80 ms, the last of the stretch among them. */
export function filmTimes({ fromUs, toUs }: Stretch): readonly number[] {
  const count = Math.floor((toUs - fromUs) / FRAME_US);
  const times = Array.from({ length: count + 1 }, (_, at) => fromUs + at * FRAME_US);
  return times.at(-1) === toUs ? times : [...times, toUs];
}

/** The initial choice: the whole run, or up to the moment at which its task was done. */
export function firstStretch(endUs: number, verdict: Pick<Verdict, 'state' | 'atMs'> | null): Stretch {
  const doneUs = verdict?.state === 'passed' && verdict.atMs !== null ? verdict.atMs * 1000 : endUs;
  return { fromUs: 0, toUs: Math.min(endUs, Math.ceil(doneUs / MOMENT_US) * MOMENT_US) };
}

/** The part of a stretch that a film has room for: its end. */
export const filmed = ({ fromUs, toUs }: Stretch): Stretch => ({
  fromUs: Math.max(fromUs, toUs - LONGEST_FILM_US),
  toUs,
});

/** Shortest stretch. */
const SHORTEST_US = 200_000;

/** The stretch with one of its ends moved as far as it goes: the other end is not passed. */
export function withEnd(stretch: Stretch, end: keyof Stretch, timeUs: number, endUs: number): Stretch {
  const { fromUs, toUs } = stretch;
  if (end === 'fromUs') return { fromUs: Math.max(0, Math.min(timeUs, toUs - SHORTEST_US)), toUs };
  return { fromUs, toUs: Math.min(endUs, Math.max(timeUs, fromUs + SHORTEST_US)) };
}
