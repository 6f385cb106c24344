import type { Clock } from '#core/clock';
import { applyEdit } from '#scene/edit';
import { movableIds } from './at-once';
import type { CourseWorld } from './course/course-world';
import type { InputAction, InputEvent } from './input';
import { InputQueue } from './input-queue';
import { checkFor, type InputTargets } from './run-problem';

/** An action that is due, and the place of its device; `null`: it names none. */
export interface DueInput {
  readonly action: InputAction;
  readonly device: number | null;
}

/** The actions from outside: checked when they come, waiting for their time, logged when they take effect. */
export class RunInputs {
  /** Every action so far with the time at which it took effect. */
  readonly log: InputEvent[] = [];
  private readonly waiting: InputQueue;

  /**
   * @param replayed what is repeated of an earlier run, in any order
   * @param arena the course and its blocks, as they were at the start and as they are now
   */
  constructor(
    replayed: readonly InputEvent[],
    private readonly targets: InputTargets,
    private readonly arena: CourseWorld,
    private readonly clock: Clock,
  ) {
    this.waiting = new InputQueue(replayed);
  }

  /** True if no action waits for its time. */
  get isEmpty(): boolean {
    return this.waiting.isEmpty;
  }

  /** @throws RangeError for what is impossible when the action takes effect; then nothing is done */
  add(action: InputAction, device?: string): void {
    const problem = this.problemOf(action, device);
    if (problem !== null) throw new RangeError(problem);
    this.waiting.add(action, this.clock.nowUs, device);
  }

  /** Takes out and logs the next action that is due, `null` when none is. */
  takeDue(): DueInput | null {
    const { nowUs } = this.clock;
    for (let event = this.waiting.takeDue(nowUs); event; event = this.waiting.takeDue(nowUs)) {
      const { action, device } = event;
      // An edit made while a log is replayed may have removed what a later entry of the log refers to.
      if (this.isMoot(action)) continue;
      this.log.push({ timeUs: nowUs, ...(device !== undefined && { device }), action });
      return { action, device: device === undefined ? null : this.targets.names.indexOf(device) };
    }
    return null;
  }

  /** Checks an action that will take effect after those that wait for the same step. */
  private problemOf(action: InputAction, device: string | undefined): string | null {
    const check = checkFor(this.targets, device);
    if (typeof check === 'string') return check;
    let course = this.arena.course;
    let movable = this.arena.movableIds();
    for (const before of this.waiting.until(this.clock.nowUs)) {
      if (before.action.type !== 'edit') continue;
      course = applyEdit(course, before.action.edit);
      movable = movableIds(movable, this.arena.began, course);
    }
    return check(action, course, movable);
  }

  private isMoot(action: InputAction): boolean {
    if (action.type !== 'edit' && action.type !== 'place-block' && action.type !== 'switch') return false;
    const [check] = this.targets.checks; // about the course, all say the same
    return check?.(action, this.arena.course, this.arena.movableIds()) !== null;
  }
}
