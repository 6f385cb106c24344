import { shallowRef, type ShallowRef } from 'vue';

import { handInOf } from '#check/hand-in/read-hand-in';
import { Lane, type Every, type StartThread } from '#check/lane';
import type { CheckResult } from '#check/result';
import type { ClassTask } from '#check/task/task';

/** What the run of a solution needs of the page. */
export interface SolutionPorts {
  /** How threads for a task are started. Rejects without the VM. */
  starter(task: ClassTask): Promise<StartThread>;
  readonly every: Every;
}

/** The model solution in all worlds of its task, run anew whenever the task has changed. */
export class SolutionRun {
  /** `null`: there is no solution, or none of its runs is over yet. */
  readonly result: ShallowRef<CheckResult | null> = shallowRef(null);
  readonly isRunning = shallowRef(false);
  /** The VM could not be fetched, or no worker made. */
  readonly hasFailed = shallowRef(false);
  private lane: Lane | null = null;
  private turn = 0;

  constructor(private readonly ports: SolutionPorts) {}

  /** Runs the solution of a task. What was running is of no more interest. */
  async run(task: ClassTask): Promise<void> {
    this.stop();
    this.result.value = null;
    const { turn } = this;
    const handIn = task.solution && handInOf({ ...task.project, files: task.solution });
    if (handIn === null || 'problem' in handIn) return;
    this.isRunning.value = true;
    this.hasFailed.value = false;
    try {
      const start = await this.ports.starter(task);
      if (turn !== this.turn) return;
      this.lane = new Lane(task.checks, start, this.ports.every);
      const result = await this.lane.check(handIn.handIn);
      if (turn === this.turn) this.result.value = result;
    } catch {
      if (turn === this.turn) this.hasFailed.value = true;
    }
    if (turn === this.turn) this.stop();
  }

  stop(): void {
    this.turn += 1;
    this.lane?.stop();
    this.lane = null;
    this.isRunning.value = false;
  }
}
