/** A thread that makes one run after the other. */
import { answerRun, type RunRequest } from '#lab/run-request';
import { answering } from '../threads/answering';
import { beatIn } from '../threads/threads';
import type { RunnerData } from './lab-messages';

answering((data) => {
  const { firmware, shared } = data as RunnerData;
  const beat = beatIn(shared);
  return (request) => answerRun(request as RunRequest, { firmware, beat });
});
