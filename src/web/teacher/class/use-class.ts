import { startsOf } from '#catalogue/starts';
import { isSame } from '#core/same';
import { taskOf } from '#check/task/read-task';
import type { Project } from '#project/project';

import { shownLanguage, t } from '../../kit/i18n';
import { lateModel } from '../../kit/state/late-models';
import { compileFirmware } from '../../session/run/worker/firmware';
import { every, laneCount, checkThread } from '../../session/run/serve-thread';
import { askOnLeaving } from './ask-on-leaving';
import { ClassKeeper } from './class-keeper';
import { ClassModel, type OpenTask } from './model/class-model';
import words from './words';

/** `OpenTask.from` of the work that is open in the app, of a file, of a series, and of a class that was stored. */
export const [OPEN, FILE, SERIES, KEPT] = ['open', 'file', 'series', 'kept'];

/** The class that is checked on this page: it stays while the page is open, also when it is out of sight. */
export const classOf = lateModel(
  () =>
    new ClassModel({
      starter: async (task) => checkThread(task, await compileFirmware(), startsOf(task.project)),
      every,
      lanes: laneCount(),
      language: shownLanguage,
    }),
);

/** The keeper that stores the class in the browser; the first call restores a stored one. */
export const keeperOf = lateModel((app) => {
  const model = classOf(app);
  const keeper = new ClassKeeper(model);
  askOnLeaving(model, keeper);
  return keeper;
});

/**
 * Makes the task of a project the one that the class is checked for; if it is already, nothing is checked again.
 *
 * @returns `null`, or the reason why it cannot be, in words
 */
export function chooseTask(model: ClassModel, project: Project, { name, from }: Omit<OpenTask, 'task'>): string | null {
  const read = taskOf(project);
  if ('problem' in read) {
    model.leaveTask();
    const [first] = read.problems;
    const hasNoGoals = first !== undefined && first.path === 'task.checks';
    return hasNoGoals ? t(words.noGoals) : t(words.badTask, { name, reason: read.problem });
  }
  const before = model.task.value;
  if (before?.from === from && isSame(before.task, read.task)) return null;
  void model.choose({ name: read.task.id || name, from, task: read.task });
  return null;
}
