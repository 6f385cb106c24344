import { computed, type ComputedRef } from 'vue';

import { freeId } from '#check/task/read-checks';
import { draftOf, lacksGoals } from '#check/task/read-task';
import { plainWorld, type ClassTask, type WorldVariant } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';

import { presentProject } from '../share/save-work';
import { isHandedOut, withoutGiven } from '../work/model/keeper';
import type { WorkParts } from '../work/model/parts';
import { workName } from '../work/work-name';

/** The task of the open work, as it is being made. It is kept with the work, as its program and its course are. */
export interface TaskMaker {
  /** `null`: what the work carries cannot be read, see `problem`. */
  readonly task: ComputedRef<ClassTask | null>;
  /** Why not, in English: it names the place in the data. */
  readonly problem: ComputedRef<string | null>;
  /** The goals of the course are checked, and it has none. */
  readonly lacksGoals: ComputedRef<boolean>;
  /** It was handed out: whoever has it does not make it over. */
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
      if (isGiven.value) app.work.openProject(withoutGiven(presentProject(app)), workName(app));
      else app.work.setTask(null);
    },
  };
}

/** Another world, which nobody sees: the course with another chance, until it is given more. */
export function freshWorld(task: ClassTask): WorldVariant {
  const count = task.worlds.length;
  return { ...plainWorld, id: freeId(String(count + 1), task.worlds), hidden: true, seed: count };
}

/** Where the robot of a world starts: there where it says, else where the course has it. */
export const startOf = ({ project }: ClassTask, world: WorldVariant): NonNullable<WorldVariant['start']> =>
  world.start ?? project.scene.robot;
