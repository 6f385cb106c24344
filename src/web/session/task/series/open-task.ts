import type { Series, SeriesTask } from '#check/series/series';
import { isSame } from '#core/same';
import type { Project } from '#project/project';

import type { LayoutParts } from '../../layout/parts';
import { shownLanguage } from '../../../kit/i18n';
import { projectOf } from '#catalogue/course';
import { courseName } from '../../work/catalogue/first-course';
import { readyCourse } from '../../work/catalogue/ready-courses';
import type { Workplace } from '../../work/model/parts';
import type { Previous } from '../../work/storage/history';
import { hasNothingOwn, useCourses } from '../../work/use-courses';
import { useOpenings } from '../../work/use-openings';
import { taskText } from '../../work/catalogue/task-text';
import { carriedPlace } from './series-place';
import { isAsGiven, taskOfWork } from './series-task';

/** The models that open tasks of a series. */
export type SeriesApp = Workplace & Pick<LayoutParts, 'router'>;

/** A task's name: the series', else its course's. */
export function taskName({ title, from }: SeriesTask): string {
  if (title !== '') return title;
  if (from.kind === 'course') return readyCourse(from.course)?.texts[shownLanguage()].name ?? from.course;
  if (from.kind !== 'project') return '';
  const { scene, course } = from.project;
  return taskText(scene, null, shownLanguage()).title || courseName(scene, course);
}

/** The pupil's own work on a task: open, put aside, or none. */
export function workOn({ work }: Pick<Workplace, 'work'>, series: Series, task: SeriesTask): 'open' | Previous | null {
  const isIt = (project: Project): boolean => taskOfWork(project, series) === task;
  const { project, previous } = work.work.value;
  return isIt(project) ? 'open' : (previous.find((entry) => isIt(entry.project)) ?? null);
}

/** Opens a task as it was handed out, or the work on it as it was left. @param anew in any case as it was handed out */
export function openTask(app: SeriesApp, series: Series, task: SeriesTask, anew = false): void {
  const { work } = app;
  const before = workOn(app, series, task);
  const openings = useOpenings(app);
  if (before !== null && !anew) {
    if (before !== 'open') openings.restore(before);
    return;
  }
  const isKept = !hasNothingOwn(work.work.value.project) && !isAsOpened(work.work.value.project, series);
  const { from } = task;
  if (from.kind === 'project') openings.open(from.project, taskName(task), !isKept);
  const course = from.kind === 'course' ? readyCourse(from.course) : null;
  if (course !== null) useCourses(app).openWhole(course, !isKept);
  work.setHandIn(carriedPlace({ series: series.id, task: task.id }));
  // The card comes with another course; here it comes with another start, too.
  work.arrivals.value += 1;
}

/** True if a project is a task of the series just as it was opened, with nothing of the pupil's own. */
function isAsOpened(project: Project, series: Series): boolean {
  const task = taskOfWork(project, series);
  if (task === null || !isAsGiven(project, task)) return false;
  const { from } = task;
  const course = from.kind === 'course' ? readyCourse(from.course) : null;
  const given = from.kind === 'project' ? from.project : course && projectOf(course, shownLanguage());
  return given !== null && isSame(given.files, project.files) && isSame(given.devices, project.devices);
}

/** The next task that can be opened; `null`: there is none. */
export function taskAfter(series: Series, task: SeriesTask): SeriesTask | null {
  const after = series.tasks.slice(series.tasks.indexOf(task) + 1);
  return after.find(({ from }) => from.kind === 'course' || from.kind === 'project') ?? null;
}
