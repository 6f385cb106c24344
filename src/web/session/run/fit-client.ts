import type { Measured } from '#my-robot/my-robot';
import { askWorker } from './worker/ask-worker';
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
  const request: FitRequest = { type: 'fit', firmware, robot, measured };
  return (await askWorker<FitAnswer>(createWorker, request, signal)).fit;
}
