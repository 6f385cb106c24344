import type { Answer, Every, Start } from '#check/lane';
import { threadOf, type Script } from './thread';

/** Index of the shared word that a thread counts up while time passes. */
const BEAT = 0;

/** Index of the shared word that holds the place of the world that is being run. */
const WORLD = 1;

/** Shared words, see `BEAT` and `WORLD`, as a part of a thread's initial data. */
export interface SharedWords {
  readonly shared: Int32Array;
}

/** The sign of life of a thread, with the place of the world that it runs; without one it is in the first. */
export const beatIn =
  (shared: Int32Array) =>
  (world = 0): void => {
    Atomics.store(shared, WORLD, world);
    Atomics.add(shared, BEAT, 1);
  };

/**
 * Starts threads of Node that answer one request after the other.
 *
 * @param dataFor the initial data of one, besides the shared words
 */
export const threads =
  <Request, Result>(script: Script, dataFor: () => object): Start<Request, Result> =>
  (heard) => {
    const shared = new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT));
    const worker = threadOf(script);
    worker.postMessage({ ...dataFor(), shared });
    worker.on('message', (answer: Answer<Result>) => heard(answer));
    worker.on('error', (error: Error) => heard({ broken: error.message }));
    worker.on('exit', () => heard({ broken: 'The thread has ended.' }));
    return {
      ask: (request) => {
        Atomics.store(shared, WORLD, 0);
        worker.postMessage(request);
      },
      pulse: () => ({ beat: Atomics.load(shared, BEAT), world: Atomics.load(shared, WORLD) }),
      stop: () => void worker.terminate(),
    };
  };

/** Calls something every so many ms. @returns a function that ends this */
export const every: Every = (ms, act) => {
  const timer = setInterval(act, ms);
  return () => clearInterval(timer);
};
