import { part } from '../../kit/part';
import type { TaskModel } from './task-model';

/** The task of the open course. */
export interface TaskParts {
  readonly task: TaskModel;
}

export const [provideTask, useTask] = part<TaskParts>('task');
