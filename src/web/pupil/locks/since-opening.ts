import { keptLines } from '#check/task/kept-lines';
import { locksOf } from '#check/task/read-task';
import { isSame } from '#core/same';
import { MAIN, type Project } from '#project/project';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { WorkParts } from '../../session/work/model/parts';
import words from './words';
import { mainText } from './main-text';

/**
 * Takes back changes of what a task locks that were made before its locks were loaded.
 *
 * @param opened the project with which it was opened
 */
export function takeBack(
  { work, notices }: Pick<PageParts, 'notices'> & Pick<WorkParts, 'work'>,
  opened: Project,
): void {
  const { task } = work.work.value.project;
  if (task === undefined || task !== opened.task) return;
  const { course, lines } = locksOf(task);
  const tell = (text: string): void => notices.show({ kind: 'info', key: 'notice.text', values: { text } });
  let isTaken = false;
  while (course && work.scene.value !== opened.scene && work.undo()) isTaken = true;
  if (isTaken) tell(t(words.course));
  const [before, now] = [mainText(opened), mainText(work.work.value.project)];
  const kept = keptLines(before, now, lines);
  if (kept === null) {
    work.setText(MAIN, before, true);
    tell(t(words.lines));
  } else if (before !== now && !isSame(kept, lines))
    work.setTask({ ...task, locks: { ...(task['locks'] as object), lines: kept } });
}
