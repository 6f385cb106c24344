import type { Start } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import type { Hint } from '#hint/hint';
import type { HintRequest } from '#hint/hint-lane';
import type { Project } from '#project/project';
import { threads, type SharedWords } from '../threads/threads';

/** The initial data of a thread that looks for hints. */
export interface HinterData extends SharedWords {
  /** The project that contains the task. */
  readonly task: Project;
  readonly firmware: WebAssembly.Module;
}

/** Starts threads of Node that look for hints to programs for a task. */
export const hintThread = (task: ClassTask, firmware: WebAssembly.Module): Start<HintRequest, Hint | null> =>
  threads('hint-worker', (): Omit<HinterData, 'shared'> => ({ task: projectOfTask(task), firmware }));
