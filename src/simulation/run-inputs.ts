import type { Clock } from '#core/clock';
import { applyEdit } from '#scene/edit';
import { movableIds } from './at-once';
import type { CourseWorld } from './course-world';
import type { InputAction, InputEvent } from './input';
import { InputQueue } from './input-queue';
import type { InputCheck } from './run-problem';

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
    private readonly check: InputCheck,
    private readonly arena: CourseWorld,
    private readonly clock: Clock,
  ) {
    this.waiting = new InputQueue(replayed);
  }

  /** Nothing waits for its time. */
  get isEmpty(): boolean {
    return this.waiting.isEmpty;
  }

  /** @throws RangeError for what is impossible when the action takes effect; then nothing is done */
  add(action: InputAction): void {
    const problem = this.problemOf(action);
    if (problem !== null) throw new RangeError(problem);
    this.waiting.add(action, this.clock.nowUs);
  }

  /** Takes out and logs the next action that is due, `null` when none is. */
  takeDue(): InputAction | null {
    const { nowUs } = this.clock;
    for (let action = this.waiting.takeDue(nowUs); action; action = this.waiting.takeDue(nowUs)) {
      // An edit made while a log is replayed may have removed what a later entry of the log refers to.
      if (this.isMoot(action)) continue;
      this.log.push({ timeUs: nowUs, action });
      return action;
    }
    return null;
  }

  /** Checks an action that will take effect after those that wait for the same step. */
  private problemOf(action: InputAction): string | null {
    let course = this.arena.course;
    let movable = this.arena.movableIds();
    for (const before of this.waiting.until(this.clock.nowUs)) {
      if (before.action.type !== 'edit') continue;
      course = applyEdit(course, before.action.edit);
      movable = movableIds(movable, this.arena.began, course);
    }
    return this.check(action, course, movable);
  }

  private isMoot(action: InputAction): boolean {
    if (action.type !== 'edit' && action.type !== 'place-block') return false;
    return this.check(action, this.arena.course, this.arena.movableIds()) !== null;
  }
}
