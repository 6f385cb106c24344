import type { RunSetup } from '#simulation/run-setup';

import { STOP_ANSWER_MS, type FromWorker, type Speed, type ToWorker } from '../worker/protocol';

/** What is used of a `Worker`. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** What the client needs and whom it tells. */
export interface ClientOptions {
  createWorker(): WorkerPort;
  /** The compiled VM. */
  firmware(): Promise<WebAssembly.Module>;
  /** Every message of the current run's worker. */
  onMessage(message: FromWorker): void;
  /** The current run had to be ended by force. */
  onKilled(): void;
}

/** How a run came to its end: by itself, or because its worker gave no answer. */
export type StopResult = 'stopped' | 'killed';

/**
 * The page's end of the runs: one worker per run, a fresh one always ready for the next, and the means to end one that
 * does not answer. Whatever a program does, it does to a worker that is thrown away.
 */
export class RunClient {
  private current: WorkerPort | null = null;
  private spare: WorkerPort | null = null;
  private onStopped: (() => void) | null = null;
  /** Counts starts and stops, so that a start that had to wait for the VM notices that it is no longer wanted. */
  private turn = 0;

  constructor(private readonly options: ClientOptions) {}

  /** Makes a worker ready for the next run. Rejects when the VM cannot be loaded. */
  async warmUp(): Promise<void> {
    if (this.spare !== null) return;
    const worker = this.options.createWorker();
    this.spare = worker;
    try {
      const firmware = await this.options.firmware();
      if (this.spare === worker || this.current === worker) worker.postMessage({ type: 'prepare', firmware });
    } catch (error) {
      if (this.spare === worker) this.spare = null;
      worker.terminate();
      throw error;
    }
  }

  /** Starts a run in the ready worker; the run before, if any, is dropped. */
  async start(setup: RunSetup, speed: Speed, paused: boolean): Promise<void> {
    this.drop();
    this.turn += 1;
    const { turn } = this;
    await this.warmUp();
    await this.options.firmware(); // a worker that is still being made ready gets its VM first
    const worker = this.spare;
    if (worker === null || turn !== this.turn) return;
    this.spare = null;
    this.current = worker;
    worker.onmessage = (event) => this.hear(worker, event.data);
    worker.onerror = (event) => this.hear(worker, { type: 'failed', message: event.message });
    worker.postMessage({ type: 'run', setup, speed, paused });
  }

  /** Sends a message to the run; without a run nothing happens. */
  send(message: Exclude<ToWorker, { type: 'prepare' | 'run' | 'stop' }>): void {
    this.current?.postMessage(message);
  }

  /** Ends the run: by asking, and by force when there is no answer within `STOP_ANSWER_MS`. */
  stop(): Promise<StopResult> {
    this.turn += 1;
    const worker = this.current;
    if (worker === null) return Promise.resolve('stopped');
    return new Promise((resolve) => {
      const timer = setTimeout(() => {
        this.onStopped = null;
        this.drop();
        this.options.onKilled();
        resolve('killed');
      }, STOP_ANSWER_MS);
      this.onStopped = () => {
        clearTimeout(timer);
        resolve('stopped');
      };
      worker.postMessage({ type: 'stop' });
    });
  }

  /** Ends the run at once, without a word. */
  drop(): void {
    const worker = this.current;
    this.current = null;
    this.onStopped?.();
    this.onStopped = null;
    if (worker === null) return;
    worker.onmessage = null;
    worker.terminate();
  }

  private hear(worker: WorkerPort, message: FromWorker): void {
    if (this.current !== worker) return;
    this.options.onMessage(message);
    if (message.type === 'stopped' || message.type === 'failed') this.drop();
  }
}
