/**
 * Makes the worker that runs a program. The single-file build puts `create-worker.single.ts` in the place of this file.
 *
 * @throws Error where the browser allows no workers
 */
export function createWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
}
