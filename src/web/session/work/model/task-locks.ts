import { shallowRef, type ShallowRef } from 'vue';

import type { SaidRemark } from '#check/hand-in/hand-in';
import type { LockName, Locks } from '#check/task/task';
import type { Project } from '#project/project';
import type { Step } from '#scene/history';
import type { InputAction } from '#simulation/input';

/** The locks of a task that was handed out, while it is open. They are loaded with the first such task (`locks`). */
export interface TaskLocks {
  readonly locks: Locks;
  /** Whether this is locked; if so, shows why. Ask it when something is about to be changed. */
  refuses(what: LockName): boolean;
  /** Whether a tool of the course editor is there. The hand always is. */
  hasTool(tool: string): boolean;
  refusesTool(tool: string): boolean;
  /** A step of the course, before it is done or taken back. */
  refusesStep(type: 'edit' | 'undo' | 'redo', step: Pick<Step, 'edit'>): boolean;
  refusesInput(action: InputAction): boolean;
  /** @param names of settings */
  refusesSettings(names: readonly string[]): boolean;
  /**
   * The project as it becomes when the pupil changes it, or `null`: refused.
   *
   * @param isTyped in the page's editor
   */
  changed(before: Project, after: Project, isTyped: boolean): Project | null;
  /** The remarks on the work when it is handed in. */
  noticed(): readonly SaidRemark[];
}

/**
 * The locks of the open task. Every change asks here, so pointer, keys, menus and hosts are all refused
 * alike, and the reason is shown; what only shows a lock asks `isLocked`.
 */
export class WorkLocks implements Omit<TaskLocks, 'locks'> {
  /** `null`: no task that was handed out is open, and nothing is locked. */
  readonly task: ShallowRef<TaskLocks | null> = shallowRef(null);

  isLocked(what: LockName): boolean {
    return Boolean(this.task.value?.locks[what]);
  }

  refuses(what: LockName): boolean {
    return this.task.value?.refuses(what) ?? false;
  }

  hasTool(tool: string): boolean {
    return this.task.value?.hasTool(tool) ?? true;
  }

  refusesTool(tool: string): boolean {
    return this.task.value?.refusesTool(tool) ?? false;
  }

  refusesStep(type: 'edit' | 'undo' | 'redo', step: Pick<Step, 'edit'>): boolean {
    return this.task.value?.refusesStep(type, step) ?? false;
  }

  refusesInput(action: InputAction): boolean {
    return this.task.value?.refusesInput(action) ?? false;
  }

  refusesSettings(names: readonly string[]): boolean {
    return this.task.value?.refusesSettings(names) ?? false;
  }

  changed(before: Project, after: Project, isTyped: boolean): Project | null {
    return this.task.value === null ? after : this.task.value.changed(before, after, isTyped);
  }

  noticed(): readonly SaidRemark[] {
    return this.task.value?.noticed() ?? [];
  }
}

/** True if the project's task was handed out to a pupil: then the page enforces its locks. */
export const isHandedOut = ({ task }: Pick<Project, 'task'>): boolean => task?.['handedOut'] === true;

/** True if the project's task is an exam that was handed out. */
export const isExam = (project: Pick<Project, 'task'>): boolean =>
  isHandedOut(project) && project.task?.['exam'] !== undefined;

/** The project without a task that was handed out, which belongs to its own course and program. */
export function withoutHandedOut(project: Project): Project {
  const { task: _, ...others } = project;
  return isHandedOut(project) ? others : project;
}
