import type { Extension } from '@codemirror/state';

import type { SaidRemark } from '#check/hand-in/hand-in';
import type { LockName, Locks } from '#check/task/task';
import type { Project } from '#project/project';
import type { Step } from '#scene/history';
import type { InputAction } from '#simulation/input';

/**
 * Keeps what a task that was handed out locks, while it is open. Each way of changing something asks here, so pointer, keys,
 * menus and hosts are all refused alike, and are told why. A late part makes it (`handed-out`).
 */
export interface Keeper {
  readonly locks: Locks;
  /** True if this is locked; whoever asks wants to change it, and has been told. */
  refuses(what: LockName): boolean;
  /** True if a tool of the course editor is there. The hand always is. */
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
  /** What is told of the work when it is handed in. */
  noticed(): readonly SaidRemark[];
  /** What the editor of a file has besides. */
  inEditor(file: string): Extension;
}

/** True if its task is a pupil's: then the page keeps what it locks. */
export const isHandedOut = ({ task }: Pick<Project, 'task'>): boolean => task?.['handedOut'] === true;

/** The project for something else: a task that was handed out belongs to its own course and program. */
export function withoutGiven(project: Project): Project {
  const { task: _, ...others } = project;
  return isHandedOut(project) ? others : project;
}
