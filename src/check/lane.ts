import type { HandIn } from './hand-in/hand-in';
import { unreadable, type CheckResult, type Reason } from './result';
import { secondsOf, type ClassTask } from './task/task';

/** A hand-in that a thread shall check. */
export interface CheckRequest {
  readonly handIn: HandIn;
  /** From this world on nothing is run, for this reason. */
  readonly lost?: { readonly from: number; readonly reason: Reason };
}

/** The answer to a request. `broken`: an error of ours; `unloaded`: a part of the thread's code did not come. */
export type Answer<Result> = { readonly result: Result } | { readonly broken: string } | { readonly unloaded: true };

export type CheckAnswer = Answer<CheckResult>;

/** A thread that answers one request after the other. */
export interface Thread<Request> {
  ask(request: Request): void;
  /** Counter of signs of progress, and the place of the world that is running. */
  pulse(): { readonly beat: number; readonly world: number };
  stop(): void;
}

/** Starts a thread. `heard` receives its answers; a thread that has ended is broken. */
export type Start<Request, Result> = (heard: (answer: Answer<Result>) => void) => Thread<Request>;

export type StartThread = Start<CheckRequest, CheckResult>;

/** Calls something at this interval, in ms of wall time; returns a function that stops it. */
export type Every = (ms: number, act: () => void) => () => void;

/**
 * After this many ms of wall time without a heartbeat a program counts as stuck inside one call that never ends, if
 * it happens a second time, too: the machine may have been busy.
 */
export const STUCK_MS = 10_000;

/**
 * The same before a thread's first sign of life, where that comes before its program begins: the thread may still be loading, and no
 * machine shall decide what a match or a run of a series comes to.
 */
export const START_MS = 60_000;

/** Longest duration of a run on any machine, in ms of wall time. Chosen: a simulation slower than that is of no use. */
const LONG_MS = 120_000;

/** Longest duration of a world of a task on any machine, in ms of wall time. */
export const longestMs = (task: ClassTask): number => Math.max(LONG_MS, 1000 * secondsOf(task));

const LOOK_MS = 200;

/** The end of a thread in the middle of a request. */
export interface Loss {
  readonly reason: Reason & { readonly code: 'stuck' | 'long' | 'broken' | 'unloaded' };
  /** The place of the world in which it was. */
  readonly world: number;
}

/** Endings that may come out otherwise a second time. */
const AGAIN: readonly Loss['reason']['code'][] = ['stuck', 'unloaded'];

/** Asks a thread, which is replaced when a request has broken it or is stuck in it. */
export class Asker<Request, Result> {
  private thread: Thread<Request> | null = null;
  /** Takes the end of the pending request; `null`: there is none. */
  private end: ((ending: { readonly result: Result } | Loss) => void) | null = null;
  private unwatch: () => void = () => undefined;

  /**
   * @param mostMs longest wall time in one world
   * @param startMs longest silence before the first sign of life
   */
  constructor(
    private readonly start: Start<Request, Result>,
    private readonly every: Every,
    private readonly mostMs: number,
    private readonly startMs = STUCK_MS,
  ) {}

  /** The answer to a request, which is asked a second time if it was stuck, or its code did not come. */
  async ask(request: Request): Promise<{ readonly result: Result } | Loss> {
    const first = await this.askOnce(request);
    return 'reason' in first && AGAIN.includes(first.reason.code) ? this.askOnce(request) : first;
  }

  /** Ends the thread. A pending request stays without an answer. */
  stop(): void {
    this.unwatch();
    this.end = null;
    this.thread?.stop();
    this.thread = null;
  }

  /** The same, asked once. */
  askOnce(request: Request): Promise<{ readonly result: Result } | Loss> {
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

  private begin(): Thread<Request> {
    const thread = this.start((answer) => {
      // One that was stopped may still have said something.
      if (this.thread !== thread) return;
      if ('broken' in answer) this.lose('broken', { problem: answer.broken });
      else if ('unloaded' in answer) this.lose('unloaded', {});
      else this.end?.(answer);
    });
    return thread;
  }

  /** Ends a request to which the thread gives no answer. */
  private lose(code: Loss['reason']['code'], params: Reason['params']): void {
    this.end?.({ reason: { code, params }, world: this.thread?.pulse().world ?? 0 });
  }

  /**
   * Gives up a thread without a sign of life, before its first for `startMs`, then for `STUCK_MS`, or slower with a world than
   * `mostMs`.
   */
  private watch(thread: Thread<Request>): () => void {
    const { mostMs, startMs } = this;
    let { beat, world } = thread.pulse();
    let [stillMs, worldMs] = [0, 0];
    return this.every(LOOK_MS, () => {
      const now = thread.pulse();
      stillMs = now.beat === beat ? stillMs + LOOK_MS : 0;
      worldMs = now.world === world ? worldMs + LOOK_MS : 0;
      ({ beat, world } = now);
      if (stillMs > (beat === 0 ? startMs : STUCK_MS)) this.lose('stuck', {});
      else if (worldMs > mostMs) this.lose('long', { seconds: mostMs / 1000 });
    });
  }
}

/** Checks one hand-in after the other in a thread. */
export class Lane {
  private readonly asker: Asker<CheckRequest, CheckResult>;

  constructor(
    private readonly task: ClassTask,
    start: StartThread,
    every: Every,
  ) {
    this.asker = new Asker(start, every, longestMs(task));
  }

  /** The result of a hand-in; in the world in which it was stuck, and in those after it, nothing is run. */
  async check(handIn: HandIn): Promise<CheckResult> {
    const ending = await this.asker.ask({ handIn });
    if ('result' in ending) return ending.result;
    const { world, reason } = ending;
    if (reason.code === 'unloaded') return unreadable(this.task.checks, { code: 'unloaded', params: {} });
    const again = await this.asker.askOnce({ handIn, lost: { from: world, reason } });
    if ('result' in again) return again.result;
    const code = again.reason.code === 'unloaded' ? 'unloaded' : 'broken';
    return unreadable(this.task.checks, { code, params: again.reason.params });
  }

  /** Ends the thread. A pending request stays without an answer. */
  stop(): void {
    this.asker.stop();
  }
}

/** Each lane takes the next thing when it is free; then all of them are stopped. */
export async function inLanes<T, L extends { stop(): void }>(
  things: Iterable<T>,
  lanes: readonly L[],
  work: (thing: T, place: number, lane: L) => Promise<void>,
): Promise<void> {
  const waiting = numbered(things);
  const busy = lanes.map(async (lane) => {
    for (const [place, thing] of waiting) await work(thing, place, lane);
    lane.stop();
  });
  await Promise.all(busy);
}

function* numbered<T>(things: Iterable<T>): Generator<readonly [number, T]> {
  let place = 0;
  for (const thing of things) yield [place++, thing];
}
