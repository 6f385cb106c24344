import type { Help } from '#scene/scene';

/** How well the robot does the course's task (`Zone`, `Spikes`, `Task` of `#scene/scene`), as plain data. */
export interface Verdict {
  /**
   * All but `open` are final: later events do not change them. `helped`: everything is done, but with help that the task
   * does not allow; it does not count as passed.
   */
  readonly state: 'open' | 'passed' | 'failed' | 'helped';
  /** Simulated ms of the decision, or `null` while it is open. */
  readonly atMs: number | null;
  /** Why it failed, or `null`. */
  readonly reason: 'time' | 'forbidden' | 'spikes' | 'touched' | null;
  /** Id of the object that was touched, or `null` for the arena's edge or nothing. */
  readonly by: string | null;
  /** Where the robot was when it was decided, or `null` while it is open. */
  readonly place: { readonly xMm: number; readonly yMm: number } | null;
  /** Help that there was until the decision, allowed or not. */
  readonly help: readonly Help[];
  /** The last place that the robot came to before its turn and has not yet come to in time, or `null`. */
  readonly early: EarlyArrival | null;
  readonly checkpoints: { readonly passed: number; readonly of: number };
  /** Targets for the robot: the number that it has reached. */
  readonly targets: { readonly reached: number; readonly of: number };
  /** Number of blocks in targets, and of wanted blocks. */
  readonly blocks: { readonly delivered: number; readonly of: number };
  /** 1 to 3 for who has passed, 0 as long as nobody has; `null` for a task that gives no stars. */
  readonly stars: number | null;
  /** Number of touches of walls, blocks, the edge or obstacles. */
  readonly touches: number;
}

/** A place that the robot came to while an earlier one was still to be reached. */
export interface EarlyArrival {
  /** Id of the checkpoint or target. */
  readonly id: string;
  /** Its number, or 0 for a target. */
  readonly number: number;
  /** The number of the checkpoint that is next. */
  readonly before: number;
}
