import { HAND_IN_VERSION } from '#check/hand-in/hand-in';
import { isRecord } from '#core/record';
import type { Carried, Project } from '#project/project';

/** Which task of which series a work is. It goes with the work: over a reload, into what is put aside, into its file. */
export interface SeriesPlace {
  readonly series: string;
  readonly task: string;
}

/** The place that the work says it has; `null`: it belongs to no series. */
export function placeOf({ handIn }: Pick<Project, 'handIn'>): SeriesPlace | null {
  const place = handIn?.['series'];
  if (!isRecord(place)) return null;
  const { series, task } = place;
  return typeof series === 'string' && typeof task === 'string' ? { series, task } : null;
}

/** The place that the work carries from now on. */
export const carriedPlace = (place: SeriesPlace, handIn?: Carried): Carried => ({
  version: HAND_IN_VERSION,
  ...handIn,
  series: { ...place },
});
