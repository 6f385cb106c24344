/** Checking hand-ins, in a worker of its own. */
import { check } from '#check/check';
import type { CheckAnswer, CheckRequest } from '#check/lane';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import type { Project } from '#project/project';

/** From the page: the task that all following hand-ins are checked for, then one after the other. */
export type ToChecker =
  | {
      readonly type: 'check-open';
      readonly task: Project;
      readonly firmware: WebAssembly.Module;
      /** Its start program in other languages. */
      readonly starts: readonly string[];
    }
  | { readonly type: 'check'; readonly request: CheckRequest };

/** To the page. */
export type FromChecker =
  | { readonly type: 'checked'; readonly answer: CheckAnswer }
  /** Time passes, in the world of this place. */
  | { readonly type: 'check-beat'; readonly world: number };

/** A sign of life is sent this often, in ms of wall time. */
const BEAT_MS = 200;

/** The worker's services that a checker uses. */
export interface CheckerPorts {
  post(message: FromChecker): void;
  nowMs(): number;
}

/** Checks the hand-ins it receives; never throws. */
export class Checker {
  private task: ClassTask | null = null;
  private firmware: WebAssembly.Module | null = null;
  private starts: readonly string[] = [];
  private saidMs = -Infinity;
  private world = -1;

  constructor(private readonly ports: CheckerPorts) {}

  async receive(message: ToChecker): Promise<void> {
    if (message.type === 'check-open') this.open(message);
    else this.ports.post({ type: 'checked', answer: await this.answer(message.request) });
  }

  private open({ task, firmware, starts }: Extract<ToChecker, { type: 'check-open' }>): void {
    const read = taskOf(task);
    this.task = 'task' in read ? read.task : null; // the page has read it, too
    this.firmware = firmware;
    this.starts = starts;
  }

  private async answer({ handIn, lost }: CheckRequest): Promise<CheckAnswer> {
    const { task, firmware, starts } = this;
    if (task === null || firmware === null) return { broken: 'There is no task.' };
    try {
      const beat = (world: number): void => this.beat(world);
      return { result: await check(task, handIn, { firmware, beat, starts, ...(lost !== undefined && { lost }) }) };
    } catch (error) {
      return { broken: error instanceof Error ? error.message : String(error) };
    }
  }

  private beat(world: number): void {
    const nowMs = this.ports.nowMs();
    if (world === this.world && nowMs - this.saidMs < BEAT_MS) return;
    [this.world, this.saidMs] = [world, nowMs];
    this.ports.post({ type: 'check-beat', world });
  }
}
