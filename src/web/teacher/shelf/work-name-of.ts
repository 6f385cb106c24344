import type { ShelfWork } from '#check/shelf/shelf';
import type { Scene } from '#scene/scene';

import { shownLanguage, t } from '../../kit/i18n';
import { taskName } from '../../session/task/series/open-task';
import { taskText } from '../../session/work/catalogue/task-text';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import words from './words';

/** The name of a work on a shelf. */
export const workNameOf = (work: ShelfWork): string =>
  work.kind === 'series'
    ? work.series.title || t(words.series)
    : taskName({ id: '', title: '', from: { kind: 'project', project: work.project } });

/** The text that pupils read first. */
export const workTextOf = (work: ShelfWork): string =>
  work.kind === 'series' ? work.series.text : taskText(work.project.scene, null, shownLanguage()).text;

/** The course in the picture of a work; `null`: it has none. */
export function sceneOfWork(work: ShelfWork): Scene | null {
  if (work.kind === 'task') return work.project.scene;
  const [first] = work.series.tasks;
  if (first?.from.kind === 'project') return first.from.project.scene;
  return first?.from.kind === 'course' ? readyScene(first.from.course) : null;
}
