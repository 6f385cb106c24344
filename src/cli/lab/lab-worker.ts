/** A thread that makes one run after the other. */
import { workerData } from 'node:worker_threads';
import { answerRun, type RunRequest } from '#lab/run-request';
import { answering } from '../threads/answering';
import { BEAT } from '../threads/threads';
import type { RunnerData } from './lab-messages';

const { firmware, shared } = workerData as RunnerData;

const beat = (): void => {
  Atomics.add(shared, BEAT, 1);
};

answering((request) => answerRun(request as RunRequest, { firmware, beat }));
