import { parentPort } from 'node:worker_threads';
import type { Answer } from '#check/lane';

/** Answers the requests to this thread, one after the other. */
export function answering(answer: (request: unknown) => Promise<unknown>): void {
  parentPort?.on('message', (request: unknown) => {
    answer(request).then(
      (result) => parentPort?.postMessage({ result } satisfies Answer<unknown>),
      (error: unknown) => {
        const broken = error instanceof Error ? (error.stack ?? error.message) : String(error);
        parentPort?.postMessage({ broken } satisfies Answer<unknown>);
      },
    );
  });
}
