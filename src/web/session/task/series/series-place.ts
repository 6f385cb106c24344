import { HAND_IN_VERSION } from '#check/hand-in/hand-in';
import type { Series, SeriesTask } from '#check/series/series';
import { isRecord } from '#core/record';
import type { Carried, Project } from '#project/project';

import { isSameArena } from '../../work/catalogue/same-arena';
import { readyCourse } from '../../work/catalogue/ready-courses';
import { isHandedOut } from '../../work/model/task-locks';

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

/** The task of the series that the work still is: another course may have been opened under its program. */
export function taskOfWork(project: Project, series: Series): SeriesTask | null {
  const place = placeOf(project);
  const task = place?.series === series.id ? series.tasks.find(({ id }) => id === place.task) : undefined;
  if (task === undefined) return null;
  const { from } = task;
  if (from.kind === 'course') return project.course === from.course ? task : null;
  if (from.kind !== 'project') return null;
  const isIt = isHandedOut(from.project) === isHandedOut(project) && from.project.scene.name === project.scene.name;
  return isIt ? task : null;
}

/** The task as it is opened; `null`: it cannot be, because it is not read or its course is unknown here. */
export function sceneOf({ from }: SeriesTask): Project['scene'] | null {
  if (from.kind === 'course') return readyCourse(from.course)?.scene ?? null;
  return from.kind === 'project' ? from.project.scene : null;
}

/** True if the work is in the course as it was handed out: only there it counts. */
export function isAsGiven(project: Project, task: SeriesTask): boolean {
  const scene = sceneOf(task);
  return scene !== null && isSameArena(scene, project.scene);
}
