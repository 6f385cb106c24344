import { projectOf } from '#catalogue/course';
import { withStart } from '#catalogue/starts';
import type { SeriesTask } from '#check/series/series';
import { documentOfSeriesLink } from '#intake/address';
import type { SeriesDocument, Unreadable } from '#intake/document';
import { seriesLinkIn } from '#intake/links';
import type { Project } from '#project/project';

import { shownLanguage } from '../../kit/i18n';
import { unreadableReason } from '../../exchange/share/unreadable-words';
import { courseName } from '../../session/work/catalogue/first-course';
import { readyCourse, readyScene } from '../../session/work/catalogue/ready-courses';
import type { ClassModel } from './model/class-model';

/**
 * Offers a series for the class: its first available task is chosen. Of an unreadable one only the problem is shown.
 */
export function offerSeries(model: ClassModel, read: SeriesDocument | Unreadable): void {
  const { brought } = model;
  if (read.kind === 'unreadable') brought.value = { ...brought.value, problem: unreadableReason(read) };
  else {
    const first = read.series.tasks.find((task) => projectIn(task) !== null);
    brought.value = { chosen: { series: read.series, task: first?.id ?? '' }, problem: null };
  }
}

/** Offers the series of a link in a text. @returns whether there is one */
export function offerLink(model: ClassModel, text: string): boolean {
  const link = seriesLinkIn(text);
  if (link !== null) offerSeries(model, documentOfSeriesLink(link, readyScene));
  return link !== null;
}

/** The project of a task as it is checked; `null`: it is not available. */
export function projectIn({ from }: SeriesTask): Project | null {
  if (from.kind === 'project') return from.project;
  const course = from.kind === 'course' ? readyCourse(from.course) : null;
  return course && withStart(projectOf(course, shownLanguage()), course);
}

/** Name in reports, as in those of the command line. */
export function reportName({ title, id }: SeriesTask, { scene, course }: Project): string {
  return title || (scene.name === '' && course === null ? id : courseName(scene, course));
}
