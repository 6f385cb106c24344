import { startsOf } from '#catalogue/starts';
import type { StartThread } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import { threads } from '../threads/threads';
import type { CheckerData } from './pool-messages';

/** Starts threads of Node that check hand-ins of a task. */
export const startThread = (task: ClassTask, firmware: WebAssembly.Module): StartThread =>
  threads('check-worker', (): Omit<CheckerData, 'shared'> => {
    return { task: projectOfTask(task), firmware, starts: startsOf(task.project) };
  });
