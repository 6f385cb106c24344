import { parentPort } from 'node:worker_threads';
import type { Answer } from '#check/lane';

type Answering = (request: unknown) => Promise<unknown>;

/** Answers the requests to this thread, one after the other. @param begin takes the initial data, the first message */
export function answering(begin: (data: unknown) => Answering): void {
  let answer: Answering | null = null;
  parentPort?.on('message', (message: unknown) => {
    if (answer === null) answer = begin(message);
    else reply(answer(message));
  });
}

function reply(answer: Promise<unknown>): void {
  answer.then(
    (result) => parentPort?.postMessage({ result } satisfies Answer<unknown>),
    (error: unknown) => {
      const broken = error instanceof Error ? (error.stack ?? error.message) : String(error);
      parentPort?.postMessage({ broken } satisfies Answer<unknown>);
    },
  );
}
