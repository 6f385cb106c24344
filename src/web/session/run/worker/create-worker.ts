/**
 * Makes the worker that runs a program. The single-file build replaces this file by `create-worker.single.ts`.
 *
 * @throws Error if the browser allows no workers
 */
export function createWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
}
