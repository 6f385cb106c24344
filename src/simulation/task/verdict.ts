import type { Points } from '#rescue-line/points';
import type { Help } from '#scene/scene';

/** How well the robots do the course's task (`Zone`, `Spikes`, `Task` of `#scene/scene`), as plain data. */
export interface Verdict {
  /**
   * All but `open` are final: later events do not change them. `helped`: everything is done, but with help that the task
   * does not allow; it does not count as passed.
   */
  readonly state: 'open' | 'passed' | 'failed' | 'helped';
  /** Simulated ms of the decision, or `null` while it is open. */
  readonly atMs: number | null;
  /** Why it failed, or `null`. */
  readonly reason: Reason | null;
  /**
   * Id of the object that was touched, or `null` for the arena's edge or nothing; name of the device whose robot was
   * touched.
   */
  readonly by: string | null;
  /** Place of the deciding robot at that time, or `null` while it is open. */
  readonly place: { readonly xMm: number; readonly yMm: number } | null;
  /** Help that there was until the decision, allowed or not. */
  readonly help: readonly Help[];
  /** The last place that a robot came to before its turn and has not yet come to in time, or `null`. */
  readonly early: EarlyArrival | null;
  /** For several robots on paths of their own: of all together, or of the one that is farthest if the first wins. */
  readonly checkpoints: { readonly passed: number; readonly of: number };
  /** Targets for the robot: the number that it has reached; of several robots like `checkpoints`. */
  readonly targets: { readonly reached: number; readonly of: number };
  /** Number of blocks in targets, and of wanted blocks. */
  readonly blocks: { readonly delivered: number; readonly of: number };
  /** 1 to 3 if the task is passed, else 0; `null` for a task that gives no stars. */
  readonly stars: number | null;
  /** Number of touches of walls, blocks, the edge or obstacles, of all robots that count. */
  readonly touches: number;
  /** The verdict on each robot, if the task is one for several (`Task.robots`); else empty. */
  readonly robots: readonly RobotVerdict[];
  /** The points of a line that is scored by the rules of a league; left out: it is not. */
  readonly points?: Points;
}

/** Why a task is failed. `robot`: another robot was touched. `left`: outside of the ring. */
export type Reason = 'time' | 'forbidden' | 'spikes' | 'touched' | 'robot' | 'left';

type Shared = 'atMs' | 'by' | 'place' | 'checkpoints' | 'targets' | 'touches';

/** The verdict on one robot of a task for several. */
export interface RobotVerdict extends Pick<Verdict, Shared> {
  /** Name of its device. */
  readonly device: string;
  /** `passed`: it has arrived, has won, or was not caught. */
  readonly state: 'open' | 'passed' | 'failed';
  /** `caught`: the first robot has touched it. `beaten`: another one was first. */
  readonly reason: Reason | 'caught' | 'beaten' | null;
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
