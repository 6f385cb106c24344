import type { HandIn } from '#check/hand-in/hand-in';
import { otherTask } from '#check/hand-in/other-task';
import type { ClassTask } from '#check/task/task';

/** The task that most hand-ins were made for. */
export interface MeantTask {
  readonly name: string;
  /** Id of the ready course that it is about; `null`: it is about none, or unknown. */
  readonly course: string | null;
  /** Number of hand-ins that were made for it, and of all. */
  readonly count: number;
  readonly of: number;
  /** True if this is the task. */
  isIt(task: ClassTask): boolean;
}

/** The task that more than half of the hand-ins were made for; `null`: there is none, or they do not say. */
export function meantTask(handIns: readonly HandIn[]): MeantTask | null {
  const groups = new Map<string, HandIn[]>();
  for (const handIn of handIns) {
    const { hasCourse, said, mark, project } = handIn;
    const key = hasCourse ? said?.task || mark || project.course || project.scene.name : '';
    if (key !== '') groups.set(key, [...(groups.get(key) ?? []), handIn]);
  }
  const [most] = [...groups.values()].toSorted((a, b) => b.length - a.length);
  const [one] = most ?? [];
  if (most === undefined || one === undefined || 2 * most.length <= handIns.length) return null;
  const { scene, course } = one.project;
  return {
    ...{ name: one.said?.task || scene.name, course, count: most.length, of: handIns.length },
    isIt: (task) => otherTask(task, one) === null,
  };
}
