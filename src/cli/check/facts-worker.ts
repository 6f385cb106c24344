/** A thread that looks at the runs of checked hand-ins, one after the other. */
import { workerData } from 'node:worker_threads';
import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult } from '#check/result';
import { taskOf } from '#check/task/read-task';
import { factsOf } from '#hint/groups/run-facts';
import { answering } from '../threads/answering';
import { BEAT } from '../threads/threads';
import type { CheckerData } from './pool-messages';

/** A checked hand-in. */
export interface FactsRequest {
  readonly handIn: HandIn;
  readonly result: CheckResult;
}

const { task: project, firmware, shared } = workerData as CheckerData;
const read = taskOf(project);
if ('problem' in read) throw new Error(read.problem); // the main thread has read it, too
const { task } = read;
const beat = (): void => void Atomics.add(shared, BEAT, 1);

answering((request) => {
  const { handIn, result } = request as FactsRequest;
  return factsOf(task, handIn, result, { firmware, beat });
});
