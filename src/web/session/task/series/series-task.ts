import type { Series, SeriesTask } from '#check/series/series';
import type { Project } from '#project/project';

import { isSameArena } from '../../work/catalogue/same-arena';
import { readyCourse } from '../../work/catalogue/ready-courses';
import { isHandedOut } from '../../work/model/task-locks';
import { placeOf } from './series-place';

/** The task of the series that the work belongs to; `null`: none, or another course was opened under its program. */
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

/** The course of a task as it is opened; `null`: the task is not read, or its course is unknown here. */
export function sceneOf({ from }: SeriesTask): Project['scene'] | null {
  if (from.kind === 'course') return readyCourse(from.course)?.scene ?? null;
  return from.kind === 'project' ? from.project.scene : null;
}

/** True if the work's course is as it was handed out: only then it counts. */
export function isAsGiven(project: Project, task: SeriesTask): boolean {
  const scene = sceneOf(task);
  return scene !== null && isSameArena(scene, project.scene);
}
