/** A thread that checks one hand-in after the other. */
import { parentPort, workerData } from 'node:worker_threads';
import { check } from '#check/check';
import type { CheckAnswer, CheckRequest } from '#check/lane';
import { taskOf } from '#check/task/read-task';
import { BEAT, WORLD, type CheckerData } from './pool-messages';

const { task: project, firmware, starts, shared } = workerData as CheckerData;
const read = taskOf(project);
if ('problem' in read) throw new Error(read.problem); // the main thread has read it, too
const { task } = read;

const beat = (world: number): void => {
  Atomics.store(shared, WORLD, world);
  Atomics.add(shared, BEAT, 1);
};

parentPort?.on('message', ({ handIn, lost }: CheckRequest) => {
  check(task, handIn, { firmware, beat, starts, ...(lost !== undefined && { lost }) }).then(
    (result) => parentPort?.postMessage({ result } satisfies CheckAnswer),
    (error: unknown) => {
      const broken = error instanceof Error ? (error.stack ?? error.message) : String(error);
      parentPort?.postMessage({ broken } satisfies CheckAnswer);
    },
  );
});
