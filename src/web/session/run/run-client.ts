import type { RunSetup } from '#simulation/run-setup';

import { unpackPictures, type OnItsWay } from './worker/pictures';
import type { FromWorker, ToWorker } from './worker/protocol';
import { STOP_ANSWER_MS } from './worker/stop-limits';

/** The part of a `Worker` that is used here. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<OnItsWay | FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** The client's needs and listeners. */
export interface ClientOptions {
  createWorker(): WorkerPort;
  /** The compiled VM. */
  firmware(): Promise<WebAssembly.Module>;
  /** Every message of the current run's worker. */
  onMessage(message: FromWorker): void;
  /** The current run had to be ended by force. */
  onKilled(): void;
}

/** The messages of a run between its start and its end. */
export type ToRun = Exclude<ToWorker, { type: 'prepare' | 'run' | 'stop' }>;

/** A worker whose run is left gives the rest of its tape within this time, in ms, or not at all. Chosen: it may be in the midst of a slice. */
const TAPE_ANSWER_MS = 300;

/** The speed and pause with which a run begins. */
export type Pace = Pick<Extract<ToWorker, { type: 'run' }>, 'speed' | 'paused' | 'catchUpUs'>;

/** Maximum number of messages that wait for their run's VM. Chosen: more than anyone causes by hand in that time. */
const MOST_EARLY = 1000;

const NO_WORKER = 'The worker could not be loaded.';

/** The end of a run: either regular, or forced because its worker gave no answer. */
export type StopResult = 'stopped' | 'killed';

/**
 * The page's end of the runs: one worker per run, a fresh one always ready for the next, and the means to end one that
 * does not answer. A program affects only its worker, which is thrown away afterwards.
 */
export class RunClient {
  private current: WorkerPort | null = null;
  /** True once the current run has begun; before that it cannot answer anything. */
  private hasBegun = false;
  private spare: WorkerPort | null = null;
  /** For the messages of the current run's worker. */
  private unpack = unpackPictures();
  private onStopped: (() => void) | null = null;
  /** Messages sent to a run whose VM is still loading; `null` without such a run. */
  private early: ToRun[] | null = null;
  /** Counts starts and stops, so that a start that waited for the VM can detect that it is no longer wanted. */
  private turn = 0;

  constructor(private readonly options: ClientOptions) {}

  /** Makes a worker ready for the next run. Rejects when the VM cannot be loaded. */
  async warmUp(): Promise<void> {
    if (this.spare !== null) return;
    const worker = this.options.createWorker();
    this.spare = worker;
    // The worker's own code could not be loaded: the next run gets a new worker.
    worker.onerror = () => {
      if (this.spare === worker) this.spare = null;
      worker.terminate();
    };
    try {
      const firmware = await this.options.firmware();
      if (this.spare === worker || this.current === worker) worker.postMessage({ type: 'prepare', firmware });
    } catch (error) {
      if (this.spare === worker) this.spare = null;
      worker.terminate();
      throw error;
    }
  }

  /**
   * A run is about to start; the previous one, if any, is dropped. Messages from now on are for the new one.
   *
   * @param hearEnd receives the last messages of the previous one: the rest of its tape, if it arrives soon
   */
  expect(hearEnd: (message: FromWorker) => void): void {
    this.leave(hearEnd);
    this.drop();
    this.turn += 1;
    this.early = [];
  }

  /**
   * Starts the expected run in the ready worker, and passes on, in order, the messages sent to it in the meantime.
   * Nothing starts if it was stopped before the VM was loaded.
   *
   * @throws Error (as a rejection) when the VM or the worker cannot be loaded
   */
  async start(setup: RunSetup, how: Pace): Promise<void> {
    const { turn } = this;
    await this.warmUp();
    await this.options.firmware(); // a worker that is still being prepared gets its VM first
    if (turn !== this.turn) return;
    await this.warmUp(); // replaces one that has failed since
    if (turn !== this.turn) return;
    const worker = this.spare;
    if (worker === null) throw new Error(NO_WORKER);
    this.spare = null;
    this.current = worker;
    this.hasBegun = false;
    this.unpack = unpackPictures();
    const { unpack } = this;
    worker.onmessage = (event) => this.hear(worker, unpack(event.data));
    worker.onerror = ({ message }) => this.hear(worker, { type: 'failed', message: message || NO_WORKER });
    worker.postMessage({ type: 'run', setup, ...how });
    for (const message of this.early ?? []) worker.postMessage(message);
    this.early = null;
  }

  /**
   * Sends a message to the run; without a run nothing happens. One that is still to start gets it then.
   *
   * @returns false if far too many messages wait already: this one is lost
   */
  send(message: ToRun): boolean {
    if (this.early !== null && this.early.length >= MOST_EARLY) return false;
    this.early?.push(message);
    this.current?.postMessage(message);
    return true;
  }

  /**
   * Ends the run: by request, or by force if there is no answer within `STOP_ANSWER_MS`. One that has not begun ends at
   * once.
   */
  stop(): Promise<StopResult> {
    this.turn += 1;
    this.early = null;
    if (!this.hasBegun) this.drop();
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

  /** The run is over for the page. Its worker hands over the rest of the tape, then it is ended. */
  private leave(hearEnd: (message: FromWorker) => void): void {
    const worker = this.current;
    if (worker === null || !this.hasBegun || this.onStopped !== null) return;
    this.current = null;
    setTimeout(() => worker.terminate(), TAPE_ANSWER_MS);
    const { unpack } = this;
    worker.onmessage = ({ data }) => {
      hearEnd(unpack(data));
      if (data.type === 'inputs') worker.terminate();
    };
    worker.postMessage({ type: 'tape' });
  }

  /** Ends the run immediately. Nobody is notified, but a pending `stop` resolves. */
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
    this.hasBegun ||= message.type === 'started';
    this.options.onMessage(message);
    if (message.type === 'stopped' || message.type === 'failed') this.drop();
  }
}
