import { HAND_IN_VERSION } from '#check/hand-in/hand-in';
import { isRecord } from '#core/record';
import type { Carried, Project } from '#project/project';

/**
 * The series and the task that a work belongs to. It goes with the work: over a reload, into the earlier works, into
 * its file.
 */
export interface SeriesPlace {
  readonly series: string;
  readonly task: string;
}

/** The place stored in a work; `null`: it belongs to no series. */
export function placeOf({ handIn }: Pick<Project, 'handIn'>): SeriesPlace | null {
  const place = handIn?.['series'];
  if (!isRecord(place)) return null;
  const { series, task } = place;
  return typeof series === 'string' && typeof task === 'string' ? { series, task } : null;
}

/** The data of a hand-in with this place, to be stored in the work. */
export const carriedPlace = (place: SeriesPlace, handIn?: Carried): Carried => ({
  version: HAND_IN_VERSION,
  ...handIn,
  series: { ...place },
});
