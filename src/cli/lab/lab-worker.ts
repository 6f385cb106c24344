/** A thread that makes one run after the other. */
import { answerRun, type RunRequest } from '#lab/run-request';
import { answering } from '../threads/answering';
import { BEAT } from '../threads/threads';
import type { RunnerData } from './lab-messages';

answering((data) => {
  const { firmware, shared } = data as RunnerData;
  const beat = (): void => {
    Atomics.add(shared, BEAT, 1);
  };
  return (request) => answerRun(request as RunRequest, { firmware, beat });
});
