import { taskOf } from '#check/task/read-task';
import type { Project } from '#project/project';

import { say } from '../page/i18n/say';
import { compileFirmware } from '../run/worker/firmware';
import type { WorkParts } from '../work/model/parts';
import { every, laneCount, startThread } from '../run/check-thread';
import { ClassModel } from './class-model';
import { classWords as words } from './class-words';

/** The class of each work: it stays while the page is open, also when it is out of sight. */
const classes = new WeakMap<WorkParts['work'], ClassModel>();

/** The class that is checked on this page. */
export function classOf({ work }: Pick<WorkParts, 'work'>): ClassModel {
  const known = classes.get(work);
  if (known !== undefined) return known;
  const made = new ClassModel({
    starter: async (task) => startThread(task, await compileFirmware()),
    every,
    lanes: laneCount(),
  });
  classes.set(work, made);
  return made;
}

/**
 * Makes the task of a project the one that the class is checked for.
 *
 * @returns or why it cannot be, in words
 */
export function chooseTask(model: ClassModel, project: Project, name: string): string | null {
  const read = taskOf(project);
  if ('problem' in read) {
    const [first] = read.problems;
    const hasNoGoals = first !== undefined && first.path === 'task.checks';
    return hasNoGoals ? say(words.noGoals) : say(words.badTask, { name, reason: read.problem });
  }
  void model.choose({ name: read.task.id || name, task: read.task });
  return null;
}
