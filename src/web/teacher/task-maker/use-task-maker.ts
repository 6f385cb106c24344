import { computed, type ComputedRef } from 'vue';

import { freeId } from '#check/task/read-checks';
import { draftOf, lacksGoals } from '#check/task/read-task';
import { plainWorld, type ClassTask, type WorldVariant } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import { exactCos, exactSin } from '#core/exact-math';

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

/**
 * Differences of a new hidden world, so that it hides something. Chosen: what a careless hand puts down, and a robot
 * with some play. Along its heading, not aside: who follows a line still has it under the sensors.
 */
const ALONG_MM = 20;
const TURNED_DEG = 5;
const USED = 0.2;

/**
 * A new hidden world: another seed, and a robot that is not ideal and starts turned, in one world farther on, in the
 * next farther back.
 */
export function freshWorld(task: ClassTask): WorldVariant {
  const count = task.worlds.length;
  const side = count % 2 === 1 ? 1 : -1;
  const { robot, size } = task.project.scene;
  const headingRad = (robot.heading * Math.PI) / 180;
  const [x, y] = robot.at;
  const along = side * ALONG_MM;
  const within = (mm: number, most: number): number => Math.min(Math.max(Math.round(mm), 0), most);
  return {
    ...{ ...plainWorld, id: freeId(String(count + 1), task.worlds), hidden: true, seed: count, reality: USED },
    start: {
      at: [within(x + along * exactCos(headingRad), size[0]), within(y + along * exactSin(headingRad), size[1])],
      heading: (robot.heading + side * TURNED_DEG) % 360,
    },
  };
}

/** The start of a world's robot: the world's, else the course's. */
export const startOf = ({ project }: ClassTask, world: WorldVariant): NonNullable<WorldVariant['start']> =>
  world.start ?? project.scene.robot;
