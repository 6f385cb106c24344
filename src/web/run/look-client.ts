import type { RunSetup } from '#simulation/run-setup';
import type { FromLooker, Look, LookWish, ToLooker } from './worker/look/protocol';

export type { Instant, Look, LookWish } from './worker/look/protocol';

/** The worker of `worker/worker.ts`, which can do more than look. */
type LookPort = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

/** What the client needs to look into a run. */
export interface LookClientOptions {
  readonly createWorker: () => LookPort;
  readonly firmware: () => Promise<WebAssembly.Module>;
  /** The run that has been, with all that was done to it. */
  readonly setup: RunSetup;
}

/** Looks into a run that has been, in a worker of its own. The newest wish wins. */
export class LookClient {
  private readonly worker: Promise<LookPort>;
  private waiting: { readonly ask: number; readonly settle: (look: Look | null) => void } | null = null;
  private asks = 0;

  constructor(options: LookClientOptions) {
    this.worker = this.open(options);
    this.worker.catch(() => undefined); // whoever asks hears of it
  }

  /**
   * Looks at a moment of the run.
   *
   * @returns `null`: there is no such moment, a newer wish has overtaken this one, or nothing can be seen
   */
  async look(wish: LookWish): Promise<Look | null> {
    this.asks += 1;
    const ask = this.asks;
    this.settle(null);
    const answer = new Promise<Look | null>((settle) => (this.waiting = { ask, settle }));
    try {
      const message: ToLooker = { type: 'look', ask, wish };
      (await this.worker).postMessage(message);
    } catch {
      this.settle(null); // the VM could not be loaded: no connection, most likely
    }
    return answer;
  }

  /** Gives the worker and its memory back. */
  end(): void {
    this.settle(null);
    this.worker.then(
      (worker) => worker.terminate(),
      () => undefined,
    );
  }

  private async open({ createWorker, firmware, setup }: LookClientOptions) {
    const module = await firmware();
    const worker = createWorker();
    worker.onmessage = ({ data }: MessageEvent<FromLooker>) => this.hear(data);
    worker.onerror = () => this.settle(null);
    const message: ToLooker = { type: 'look-into', firmware: module, setup };
    worker.postMessage(message);
    return worker;
  }

  private hear(data: FromLooker): void {
    if (data.type === 'look-failed') this.settle(null);
    else if (data.ask === this.waiting?.ask) this.settle(data.look);
  }

  private settle(look: Look | null): void {
    const { waiting } = this;
    this.waiting = null;
    waiting?.settle(look);
  }
}
