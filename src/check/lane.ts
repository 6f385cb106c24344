import type { HandIn } from './hand-in/hand-in';
import { unreadable, type CheckResult, type Reason } from './result';
import { secondsOf, type ClassTask } from './task/task';

/** A hand-in that a thread shall check. */
export interface CheckRequest {
  readonly handIn: HandIn;
  /** From this world on nothing is run, for this reason. */
  readonly lost?: { readonly from: number; readonly reason: Reason };
}

/** Its answer. `broken`: an error of ours. */
export type CheckAnswer = { readonly result: CheckResult } | { readonly broken: string };

/** A thread that checks one hand-in after the other. */
export interface CheckThread {
  ask(request: CheckRequest): void;
  /** Counter of signs of progress, and the place of the world that is running. */
  pulse(): { readonly beat: number; readonly world: number };
  stop(): void;
}

/** Starts a thread. `heard` receives its answers; a thread that has ended is broken. */
export type StartThread = (heard: (answer: CheckAnswer) => void) => CheckThread;

/** Calls something at this interval, in ms of wall time; returns a function that stops it. */
export type Every = (ms: number, act: () => void) => () => void;

/**
 * After this many ms of wall time without a heartbeat a program counts as stuck inside one call that never ends, if
 * it happens a second time, too: the machine may have been busy.
 */
export const STUCK_MS = 10_000;

/** Longest duration of a run on any machine, in ms of wall time. Chosen: a simulation slower than that is of no use. */
const LONG_MS = 120_000;

const LOOK_MS = 200;

/** End of a request: with an answer, or with the end of the thread. */
type Ending = { readonly result: CheckResult } | { readonly reason: Reason; readonly world: number };

/** A thread that is replaced when a hand-in has broken it or is stuck in it. */
export class Lane {
  private thread: CheckThread | null = null;
  /** Takes the answer to the pending request; `null`: there is none. */
  private end: ((ending: Ending) => void) | null = null;
  private unwatch: () => void = () => undefined;

  constructor(
    private readonly task: ClassTask,
    private readonly start: StartThread,
    private readonly every: Every,
  ) {}

  /** The result of a hand-in; in the world in which it was stuck, and in those after it, nothing is run. */
  async check(handIn: HandIn): Promise<CheckResult> {
    const first = await this.ask({ handIn });
    const isStuck = 'reason' in first && first.reason.code === 'stuck';
    const ending = isStuck ? await this.ask({ handIn }) : first;
    if ('result' in ending) return ending.result;
    const { world, reason } = ending;
    const again = await this.ask({ handIn, lost: { from: world, reason } });
    return 'result' in again
      ? again.result
      : unreadable(this.task.checks, { code: 'broken', params: again.reason.params });
  }

  /** Ends the thread. A pending request stays without an answer. */
  stop(): void {
    this.unwatch();
    this.end = null;
    this.thread?.stop();
    this.thread = null;
  }

  private ask(request: CheckRequest): Promise<Ending> {
    const thread = (this.thread ??= this.begin());
    return new Promise((resolve) => {
      this.unwatch = this.watch(thread);
      this.end = (ending) => {
        this.unwatch();
        this.end = null;
        if ('reason' in ending) this.stop();
        resolve(ending);
      };
      thread.ask(request);
    });
  }

  private begin(): CheckThread {
    const thread = this.start((answer) => {
      // One that was stopped may still have said something.
      if (this.thread !== thread) return;
      if ('broken' in answer) this.lose('broken', { problem: answer.broken });
      else this.end?.(answer);
    });
    return thread;
  }

  /** Ends a request to which the thread gives no answer. */
  private lose(code: 'stuck' | 'long' | 'broken', params: Reason['params']): void {
    this.end?.({ reason: { code, params }, world: this.thread?.pulse().world ?? 0 });
  }

  /** Gives up a thread without a sign of life for `STUCK_MS`, or slower with a world than the real robot would be. */
  private watch(thread: CheckThread): () => void {
    const mostMs = Math.max(LONG_MS, 1000 * secondsOf(this.task));
    let { beat, world } = thread.pulse();
    let [stillMs, worldMs] = [0, 0];
    return this.every(LOOK_MS, () => {
      const now = thread.pulse();
      stillMs = now.beat === beat ? stillMs + LOOK_MS : 0;
      worldMs = now.world === world ? worldMs + LOOK_MS : 0;
      ({ beat, world } = now);
      if (stillMs > STUCK_MS) this.lose('stuck', {});
      else if (worldMs > mostMs) this.lose('long', { seconds: mostMs / 1000 });
    });
  }
}

/** Each lane takes the next thing when it is free; then all of them are stopped. */
export async function inLanes<T>(
  things: readonly T[],
  lanes: readonly Lane[],
  work: (thing: T, place: number, lane: Lane) => Promise<void>,
): Promise<void> {
  const waiting = things.entries();
  const busy = lanes.map(async (lane) => {
    for (const [place, thing] of waiting) await work(thing, place, lane);
    lane.stop();
  });
  await Promise.all(busy);
}
