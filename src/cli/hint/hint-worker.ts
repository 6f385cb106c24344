/** A thread that looks for a hint to one program after the other. */
import { taskReadBefore } from '#check/task/read-task';
import { hintFor } from '#hint/hint';
import type { HintRequest } from '#hint/hint-lane';
import { answering } from '../threads/answering';
import { beatIn } from '../threads/threads';
import type { HinterData } from './hint-thread';

answering((data) => {
  const { task: project, firmware, shared } = data as HinterData;
  const task = taskReadBefore(project);
  const beat = beatIn(shared);
  return (request) => {
    const { handIn, budget } = request as HintRequest;
    return hintFor(task, handIn, { firmware, budget, beat });
  };
});
