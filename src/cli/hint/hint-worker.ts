/** A thread that looks for a hint to one program after the other. */
import { workerData } from 'node:worker_threads';
import { taskOf } from '#check/task/read-task';
import { hintFor } from '#hint/hint';
import type { HintRequest } from '#hint/hint-lane';
import { answering } from '../threads/answering';
import { BEAT, WORLD } from '../threads/threads';
import type { HinterData } from './hint-thread';

const { task: project, firmware, shared } = workerData as HinterData;
const read = taskOf(project);
if ('problem' in read) throw new Error(read.problem); // the main thread has read it, too
const { task } = read;

const beat = (place: number): void => {
  Atomics.store(shared, WORLD, place);
  Atomics.add(shared, BEAT, 1);
};

answering((request) => {
  const { handIn, budget } = request as HintRequest;
  return hintFor(task, handIn, { firmware, budget, beat });
});
