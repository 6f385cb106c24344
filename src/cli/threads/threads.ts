import { fileURLToPath } from 'node:url';
import { setFlagsFromString } from 'node:v8';
import { Worker } from 'node:worker_threads';
import type { Answer, Every, Start } from '#check/lane';
import { STACK_MB } from '../supervise';

/** JavaScript's memory of a thread. Chosen: many times what a run takes; beyond it only the thread ends. */
const HEAP_MB = 512;

/**
 * Room for a thread's young objects from the beginning, in MB: while it grows, it is collected more often, and what lives
 * is copied each time. Measured in a check of six hand-ins: 49 collections become 26. More would take more memory.
 */
const YOUNG_MB = 8;

/**
 * Old objects before they are collected for the first time, in MB. A collection throws away the machine code that knew an
 * object of a run that is over, and the next runs are slow until it is made anew. Chosen: see decision 0112.
 */
const OLD_MB = 32;

/** Index of the shared word that a thread counts up while time passes. */
export const BEAT = 0;

/** Index of the shared word that holds the place of the world that is being run. */
export const WORLD = 1;

/** Shared words, see `BEAT` and `WORLD`, as a part of a thread's initial data. */
export interface SharedWords {
  readonly shared: Int32Array;
}

/**
 * Starts threads of Node that answer one request after the other.
 *
 * @param script name of their script beside the command line's
 * @param dataFor the initial data of one, besides the shared words
 */
export const threads =
  <Request, Result>(script: string, dataFor: () => object): Start<Request, Result> =>
  (heard) => {
    // Worker threads have no options for these two.
    setFlagsFromString(`--min-semi-space-size=${YOUNG_MB}`);
    setFlagsFromString(`--initial-old-space-size=${OLD_MB}`);
    const shared = new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT));
    const worker = new Worker(fileURLToPath(new URL(`./${script}.mjs`, import.meta.url)), {
      workerData: { ...dataFor(), shared },
      resourceLimits: { stackSizeMb: STACK_MB, maxOldGenerationSizeMb: HEAP_MB },
    });
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
