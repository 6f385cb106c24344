import type { Measured } from '#my-robot/my-robot';
import { createWorker } from './worker/create-worker';
import { compileFirmware } from './worker/firmware';
import type { Fit, FitAnswer, FitRequest } from './worker/fit';

export type { Fit } from './worker/fit';

/**
 * Fits a robot of this type to measurements, in a worker of its own.
 *
 * @param signal ends the worker: the promise then never settles
 * @throws Error (as a rejection) when worker or VM cannot be loaded
 */
export async function fitInWorker(robot: string, measured: Measured, signal: AbortSignal): Promise<Fit> {
  const firmware = await compileFirmware();
  if (signal.aborted) return new Promise(() => undefined);
  const worker = createWorker();
  signal.addEventListener('abort', () => worker.terminate());
  try {
    return await new Promise<Fit>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<FitAnswer>) => {
        if (data.type === 'fitted') resolve(data.fit);
        else reject(new Error(data.message));
      };
      worker.onerror = ({ message }) => reject(new Error(message));
      const request: FitRequest = { type: 'fit', firmware, robot, measured };
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
