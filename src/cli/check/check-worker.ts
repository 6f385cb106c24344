/** A thread that checks one hand-in after the other. */
import { check } from '#check/check';
import type { CheckRequest } from '#check/lane';
import { rehearse } from '#check/rehearse';
import { taskReadBefore } from '#check/task/read-task';
import { answering } from '../threads/answering';
import { beatIn } from '../threads/threads';
import type { CheckerData } from './pool-messages';

answering((data) => {
  const { task: project, firmware, starts, shared } = data as CheckerData;
  const task = taskReadBefore(project);
  const beat = beatIn(shared);
  let rehearsed: Promise<void> | null = null;
  return async (request) => {
    const { handIn, lost } = request as CheckRequest;
    await (rehearsed ??= rehearse(task, handIn, { firmware }));
    return check(task, handIn, { firmware, beat, starts, ...(lost !== undefined && { lost }) });
  };
});
