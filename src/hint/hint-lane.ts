import type { HandIn } from '#check/hand-in/hand-in';
import { Asker, longestMs, type Every, type Loss, type Start } from '#check/lane';
import type { ClassTask } from '#check/task/task';
import { visibleTask } from '#check/task/visible';
import type { Hint } from './hint';
import { mainOf } from './main-of';

/** A program that a thread shall find a hint to. */
export interface HintRequest {
  readonly handIn: HandIn;
  /** The most programs that are tried. */
  readonly budget: number;
}

/** Looks for hints in a thread, and answers also if a program never comes out of a call. */
export class HintLane {
  private readonly asker: Asker<HintRequest, Hint | null>;

  constructor(
    private readonly task: ClassTask,
    start: Start<HintRequest, Hint | null>,
    every: Every,
  ) {
    this.asker = new Asker(start, every, longestMs(task));
  }

  /** The hint to a program; `null`: it passes. */
  async hint(handIn: HandIn, budget: number): Promise<Hint | null> {
    const ending = await this.asker.ask({ handIn, budget });
    if ('result' in ending) return ending.result;
    const tried = triedBefore(this.task, ending);
    if (tried < 0) return lostHint(handIn, ending);
    // A changed program was stuck: there is no hint but what the tries before it have found.
    const again = await this.asker.askOnce({ handIn, budget: tried });
    return 'result' in again ? again.result : lostHint(handIn, again);
  }

  /** Ends the thread. A pending request stays without an answer. */
  stop(): void {
    this.asker.stop();
  }
}

/** Number of whole tries before a thread was lost; negative: it was lost with the program as it is. */
const triedBefore = (task: ClassTask, { world }: Loss): number => world - visibleTask(task).worlds.length - 1;

const lostHint = (handIn: HandIn, { reason }: Loss): Hint => ({
  ...{ reason, world: null, atMs: null, moment: null, change: null, tried: 0, program: mainOf(handIn) },
  happened: reason.code === 'stuck' ? { fact: 'stuck' } : { fact: 'reason', reason },
});
