/** A thread that looks at the runs of checked hand-ins, one after the other. */
import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult } from '#check/result';
import { taskReadBefore } from '#check/task/read-task';
import { factsOf } from '#hint/groups/run-facts';
import { answering } from '../threads/answering';
import { beatIn } from '../threads/threads';
import type { CheckerData } from './pool-messages';

/** A checked hand-in. */
export interface FactsRequest {
  readonly handIn: HandIn;
  readonly result: CheckResult;
}

answering((data) => {
  const { task: project, firmware, shared } = data as CheckerData;
  const task = taskReadBefore(project);
  const beat = beatIn(shared);
  return (request) => {
    const { handIn, result } = request as FactsRequest;
    return factsOf(task, handIn, result, { firmware, beat });
  };
});
