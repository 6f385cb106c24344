import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import { startsOf } from '#catalogue/starts';
import type { CheckAnswer, StartThread } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import { STACK_MB } from '../supervise';
import { BEAT, WORLD, type CheckerData } from './pool-messages';

/** JavaScript's memory of a thread. Chosen: many times what a run takes; beyond it only the thread ends. */
const HEAP_MB = 512;

/** Starts threads of Node that check hand-ins of a task. */
export const startThread =
  (task: ClassTask, firmware: WebAssembly.Module): StartThread =>
  (heard) => {
    const starts = startsOf(task.project);
    const shared = new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT));
    const workerData: CheckerData = { task: projectOfTask(task), firmware, starts, shared };
    const worker = new Worker(fileURLToPath(new URL('./check-worker.mjs', import.meta.url)), {
      workerData,
      resourceLimits: { stackSizeMb: STACK_MB, maxOldGenerationSizeMb: HEAP_MB },
    });
    worker.on('message', (answer: CheckAnswer) => heard(answer));
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
