/** A thread that checks one hand-in after the other. */
import { workerData } from 'node:worker_threads';
import { check } from '#check/check';
import type { CheckRequest } from '#check/lane';
import { taskOf } from '#check/task/read-task';
import { answering } from '../threads/answering';
import { BEAT, WORLD } from '../threads/threads';
import type { CheckerData } from './pool-messages';

const { task: project, firmware, starts, shared } = workerData as CheckerData;
const read = taskOf(project);
if ('problem' in read) throw new Error(read.problem); // the main thread has read it, too
const { task } = read;

const beat = (world: number): void => {
  Atomics.store(shared, WORLD, world);
  Atomics.add(shared, BEAT, 1);
};

answering((request) => {
  const { handIn, lost } = request as CheckRequest;
  return check(task, handIn, { firmware, beat, starts, ...(lost !== undefined && { lost }) });
});
