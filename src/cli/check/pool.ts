import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { HandIn } from '#check/hand-in/hand-in';
import { unreadable, type CheckResult, type Reason } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import { STACK_MB, STUCK_MS } from '../supervise';
import { BEAT, WORLD, type CheckAnswer, type CheckerData, type CheckRequest } from './pool-messages';

const LOOK_MS = 200;

/** JavaScript's memory of a thread. Chosen: many times what a run takes; beyond it only the thread ends. */
const HEAP_MB = 512;

/** How a request ended: with an answer, or with the thread's end. */
type Ending = { readonly result: CheckResult } | { readonly reason: Reason; readonly world: number };

/** A thread that checks, and is replaced when a hand-in has broken it or is stuck in it. */
export class Lane {
  private worker: Worker | null = null;
  /** Takes the answer to what the thread is asked; `null`: it is asked nothing. */
  private end: ((ending: Ending) => void) | null = null;
  private readonly shared = new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT));

  constructor(
    private readonly task: ClassTask,
    private readonly firmware: WebAssembly.Module,
  ) {}

  /** The result of a hand-in; in the world in which it was stuck, and in those after it, nothing is run. */
  async check(handIn: HandIn): Promise<CheckResult> {
    const ending = await this.ask({ handIn });
    if ('result' in ending) return ending.result;
    const { world, reason } = ending;
    const again = await this.ask({ handIn, lost: { from: world, reason } });
    return 'result' in again
      ? again.result
      : unreadable(this.task.checks, String(again.reason.params['problem'] ?? ''));
  }

  /** Ends the thread. */
  stop(): void {
    void this.worker?.terminate();
    this.worker = null;
  }

  private ask(request: CheckRequest): Promise<Ending> {
    const worker = (this.worker ??= this.start());
    return new Promise((resolve) => {
      const watch = this.watch(() => this.lose('stuck', {}));
      this.end = (ending) => {
        clearInterval(watch);
        this.end = null;
        if ('reason' in ending) this.stop();
        resolve(ending);
      };
      Atomics.store(this.shared, WORLD, 0);
      worker.postMessage(request);
    });
  }

  /** The thread has no answer to what it is asked. */
  private lose(code: 'stuck' | 'broken', params: Reason['params']): void {
    this.end?.({ reason: { code, params }, world: Atomics.load(this.shared, WORLD) });
  }

  private start(): Worker {
    const { task, firmware, shared } = this;
    const workerData: CheckerData = { task: projectOfTask(task), firmware, shared };
    const worker = new Worker(fileURLToPath(new URL('./check-worker.mjs', import.meta.url)), {
      workerData,
      resourceLimits: { stackSizeMb: STACK_MB, maxOldGenerationSizeMb: HEAP_MB },
    });
    // One that was stopped may still have said something.
    const broken = (problem: string): void => {
      if (this.worker === worker) this.lose('broken', { problem });
    };
    worker.on('message', (answer: CheckAnswer) => {
      if ('broken' in answer) broken(answer.broken);
      else if (this.worker === worker) this.end?.(answer);
    });
    worker.on('error', (error: Error) => broken(error.message));
    worker.on('exit', () => broken('The thread has ended.'));
    return worker;
  }

  /** Calls `stuck` when the thread shows no sign of life for `STUCK_MS`. */
  private watch(stuck: () => void): NodeJS.Timeout {
    let beat = Atomics.load(this.shared, BEAT);
    let changedMs = performance.now();
    return setInterval(() => {
      const now = Atomics.load(this.shared, BEAT);
      if (now !== beat) [beat, changedMs] = [now, performance.now()];
      else if (performance.now() - changedMs > STUCK_MS) stuck();
    }, LOOK_MS);
  }
}
