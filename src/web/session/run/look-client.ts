import type { RunSetup } from '#simulation/run-setup';
import type { Cause } from '#simulation/causes/causes';
import type { FromLooker, Instant, Look, LookWish, ToLooker, WhyWish } from './worker/look/protocol';

export type { Instant, Look, LookWish, WhyWish } from './worker/look/protocol';

/** The worker of `worker/worker.ts`, which can do more than look. */
type LookPort = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

/** The services that the client uses. */
export interface LookClientOptions {
  readonly createWorker: () => LookPort;
  readonly firmware: () => Promise<WebAssembly.Module>;
  /** Set-up of the past run, with all its inputs. */
  readonly setup: RunSetup;
}

/** A request that waits for an answer. */
interface Waiting {
  readonly ask: number;
  readonly settle: (found: FromLooker | null) => void;
}

/** Inspects a past run, in a worker of its own. The newest request of each kind wins. */
export class LookClient {
  private readonly worker: Promise<LookPort>;
  private readonly waiting = new Map<'look' | 'why', Waiting>();
  private asks = 0;

  constructor(options: LookClientOptions) {
    this.worker = this.open(options);
    this.worker.catch(() => undefined); // each request handles the failure itself
  }

  /**
   * Inspects a moment of the run.
   *
   * @returns `null`: there is no such moment, a newer request has replaced this one, or nothing can be seen
   */
  async look(wish: LookWish): Promise<Look | null> {
    const found = await this.ask('look', (ask) => ({ type: 'look', ask, wish }));
    return found?.type === 'looked' ? found.look : null;
  }

  /** Finds the lines that caused an output. @returns `null` as with `look` */
  async why(wish: WhyWish): Promise<readonly Cause[] | null> {
    const found = await this.ask('why', (ask) => ({ type: 'why', ask, wish }));
    return found?.type === 'caused' ? found.causes : null;
  }

  /** Lets the worker come near a moment before anything is asked, unless something is. */
  async prepare(at: Instant): Promise<void> {
    const worker = await this.worker.catch(() => null);
    if (this.waiting.size === 0) worker?.postMessage({ type: 'look-near', at } satisfies ToLooker);
  }

  private async ask(kind: 'look' | 'why', messageOf: (ask: number) => ToLooker): Promise<FromLooker | null> {
    this.asks += 1;
    const ask = this.asks;
    this.waiting.get(kind)?.settle(null);
    const answer = new Promise<FromLooker | null>((settle) => this.waiting.set(kind, { ask, settle }));
    try {
      (await this.worker).postMessage(messageOf(ask));
    } catch {
      this.giveUp(); // the VM could not be loaded: no connection, most likely
    }
    return answer;
  }

  /** Ends the worker. Pending requests are answered with `null`. */
  end(): void {
    this.giveUp();
    this.worker.then(
      (worker) => worker.terminate(),
      () => undefined,
    );
  }

  private async open({ createWorker, firmware, setup }: LookClientOptions) {
    const module = await firmware();
    const worker = createWorker();
    worker.onmessage = ({ data }: MessageEvent<FromLooker>) => this.hear(data);
    worker.onerror = () => this.giveUp();
    const message: ToLooker = { type: 'look-into', firmware: module, setup };
    worker.postMessage(message);
    return worker;
  }

  private hear(data: FromLooker): void {
    if (data.type === 'look-failed') return this.giveUp();
    for (const [kind, { ask, settle }] of this.waiting)
      if (ask === data.ask) {
        this.waiting.delete(kind);
        settle(data);
      }
  }

  private giveUp(): void {
    for (const { settle } of this.waiting.values()) settle(null);
    this.waiting.clear();
  }
}
