import { computed, type ComputedRef } from 'vue';

import { draftOf, lacksGoals } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';

import { presentProject } from '../../session/work/save-work';
import { isHandedOut, withoutHandedOut } from '../../session/work/model/task-locks';
import type { WorkParts } from '../../session/work/model/parts';
import { workName } from '../../session/work/work-name';

/** The task of the open work, as it is being made. It is stored with the work, as its program and its course are. */
export interface TaskMaker {
  /** `null`: what the work carries cannot be read, see `problem`. */
  readonly task: ComputedRef<ClassTask | null>;
  /** The reason why it cannot be read, in English: it names the place in the data. `null`: it can. */
  readonly problem: ComputedRef<string | null>;
  /** The goals of the course are checked, and it has none. */
  readonly lacksGoals: ComputedRef<boolean>;
  /** True if the task was handed out: then it is not changed here. */
  readonly isGiven: ComputedRef<boolean>;
  change(part: Partial<ClassTask>): void;
  /** Begins anew, without what was made so far; what was handed out is put aside. */
  clear(): void;
}

export function useTaskMaker(app: WorkParts): TaskMaker {
  const read = computed(() => draftOf(presentProject(app)));
  const task = computed(() => ('task' in read.value ? read.value.task : null));
  const isGiven = computed(() => isHandedOut(app.work.work.value.project));
  return {
    task,
    problem: computed(() => ('problem' in read.value ? read.value.problem : null)),
    lacksGoals: computed(() => task.value !== null && lacksGoals(task.value)),
    change(part) {
      if (task.value !== null) app.work.setTask(projectOfTask({ ...task.value, ...part }).task ?? null);
    },
    isGiven,
    clear() {
      if (isGiven.value) app.work.openProject(withoutHandedOut(presentProject(app)), workName(app));
      else app.work.setTask(null);
    },
  };
}
