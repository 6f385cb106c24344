/** A thread that looks at the runs of checked hand-ins, one after the other. */
import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult } from '#check/result';
import { factsOf } from '#hint/groups/run-facts';
import { answering } from '../threads/answering';
import { taskIn } from '../threads/task-in';
import { BEAT } from '../threads/threads';
import type { CheckerData } from './pool-messages';

/** A checked hand-in. */
export interface FactsRequest {
  readonly handIn: HandIn;
  readonly result: CheckResult;
}

answering((data) => {
  const { task: project, firmware, shared } = data as CheckerData;
  const task = taskIn(project);
  const beat = (): void => void Atomics.add(shared, BEAT, 1);
  return (request) => {
    const { handIn, result } = request as FactsRequest;
    return factsOf(task, handIn, result, { firmware, beat });
  };
});
