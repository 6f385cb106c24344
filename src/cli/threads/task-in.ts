import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import type { Project } from '#project/project';

/** The task in a thread's initial data: the main thread has read it, too. */
export function taskIn(project: Project): ClassTask {
  const read = taskOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return read.task;
}
