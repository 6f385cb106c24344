import type { LookClientOptions } from './look-client';
import type { Repeated, RepeatAnswer, RepeatRequest } from './worker/look/repeat';

export type { Repeated } from './worker/look/repeat';

/** The page's part of a request. */
export type RepeatWish = Pick<RepeatRequest, 'setup' | 'untilUs' | 'untilProgramEnds' | 'momentsSinceUs'>;

/**
 * Repeats a recorded run to a time or its end, in a worker of its own.
 *
 * @param tell receives the progress, as simulated time, about ten times a second
 * @param signal ends the worker
 * @throws Error (as a rejection) when it was ended, the run cannot be made, or the VM cannot be loaded
 */
export async function repeatInWorker(
  { createWorker, firmware }: Pick<LookClientOptions, 'createWorker' | 'firmware'>,
  wish: RepeatWish,
  tell: (nowUs: number) => void,
  signal: AbortSignal,
): Promise<Repeated> {
  const vm = await firmware();
  signal.throwIfAborted();
  const worker = createWorker();
  try {
    return await new Promise<Repeated>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(new Error('It was given up.')));
      worker.onmessage = ({ data }: MessageEvent<RepeatAnswer>) => {
        if (data.type === 'repeating') tell(data.nowUs);
        else if (data.type === 'repeated') resolve(data.repeated);
        else reject(new Error(data.message));
      };
      worker.onerror = ({ message }) => reject(new Error(message));
      const request: RepeatRequest = { type: 'repeat', firmware: vm, ...wish };
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
