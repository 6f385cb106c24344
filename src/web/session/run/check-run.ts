import { shallowRef, type ShallowRef } from 'vue';

import { handInOf } from '#check/hand-in/read-hand-in';
import { Lane, type Every, type StartThread } from '#check/lane';
import type { CheckResult } from '#check/result';
import type { ClassTask } from '#check/task/task';
import type { Project } from '#project/project';

import { every, checkThread } from './serve-thread';
import { compileFirmware } from './worker/firmware';
import { troubleKey, type TroubleKey } from './worker/firmware-trouble';

/** The page's services that a check uses. */
export interface CheckPorts {
  /** Gives a function that starts threads for a task. Rejects without the VM. */
  starter(task: ClassTask): Promise<StartThread>;
  readonly every: Every;
}

/** Threads in workers of their own. */
const inWorkers: CheckPorts = { starter: async (task) => checkThread(task, await compileFirmware()), every };

/** Checks one project at a time as a hand-in of a task: a model solution, or a pupil's own work. */
export class CheckRun {
  /** Result of the last check; `null`: nothing was checked, or the check is not over or has failed. */
  readonly result: ShallowRef<CheckResult | null> = shallowRef(null);
  readonly isRunning = shallowRef(false);
  /** Reason for which nothing can be checked: there is no VM, or no worker; `null`: checking is possible. */
  readonly failure: ShallowRef<TroubleKey | null> = shallowRef(null);
  private lane: Lane | null = null;
  private turn = 0;

  constructor(private readonly ports: CheckPorts = inWorkers) {}

  /**
   * Checks a project and drops a check in progress. Without a project, or with one that is no hand-in, there is no
   * result.
   */
  async run(task: ClassTask, project: Project | null): Promise<void> {
    this.stop();
    this.result.value = null;
    const { turn } = this;
    const handIn = project && handInOf(project);
    if (handIn === null || 'problem' in handIn) return;
    this.isRunning.value = true;
    this.failure.value = null;
    try {
      const start = await this.ports.starter(task);
      if (turn !== this.turn) return;
      this.lane = new Lane(task, start, this.ports.every);
      const result = await this.lane.check(handIn.handIn);
      if (turn === this.turn) this.result.value = result;
    } catch (error) {
      if (turn === this.turn) this.failure.value = troubleKey(error);
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
