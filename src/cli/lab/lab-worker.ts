/** A thread that makes one run after the other. */
import { workerData } from 'node:worker_threads';
import { ranTo } from '#lab/outcome';
import { fitRun } from '#simulation/run-problem';
import { answering } from '../threads/answering';
import { BEAT } from '../threads/threads';
import type { RunAnswer, RunnerData, RunRequest } from './lab-messages';

const { firmware, shared } = workerData as RunnerData;

const beat = (): void => {
  Atomics.add(shared, BEAT, 1);
};

answering((request): Promise<RunAnswer> => {
  const { setup, end } = request as RunRequest;
  const checked = fitRun(setup);
  if ('problem' in checked) return Promise.resolve({ refused: checked.problem });
  return ranTo(setup, end, { firmware, beat });
});
