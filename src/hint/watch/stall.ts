import type { WorldResult } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { Approach } from '#check/run/approach';
import type { Onlooker } from '#check/run/run-world';
import type { Simulation } from '#simulation/simulation';

/** Simulated time between two looks. Chosen: a robot at full speed drives some centimetres. */
const LOOK_US = 100_000;
/** Side of the squares by which a place counts as new, in mm. Chosen: half a robot. */
const SQUARE_MM = 50;
/**
 * Simulated time without a new place, or away from the line that was left, after which nothing comes of a run. Chosen: longer
 * than a robot has to wait for a gate.
 */
const STALL_US = 10_000_000;
/** The same where places come again. */
const ROUNDS_US = 60_000_000;

/** Gives up a run in which nothing new happens any more, and measures how far it got. */
export class Stall implements Onlooker {
  private readonly approach: Approach;
  private readonly squares = new Set<string>();
  private newUs = 0;
  private reached = 0;
  private isStalled = false;
  private lastUs = 0;

  /** True for a task in which places are reached several times. */
  private readonly comesAgain: boolean;

  constructor({ project, checks }: ClassTask) {
    this.approach = new Approach(project.scene);
    this.comesAgain = checks.some(({ type }) => type === 'laps');
  }

  get hasEnough(): boolean {
    return this.isStalled;
  }

  /** Simulated time of the run up to here. */
  get seconds(): number {
    return this.lastUs / 1_000_000;
  }

  /** How far it got: places reached, then the distance to the next one in mm. More is better. */
  get score(): number {
    return this.reached * REACHED_MM - (this.approach.nearestMm ?? REACHED_MM);
  }

  look(run: Simulation): void {
    const { nowUs, pose } = run;
    this.lastUs = nowUs;
    this.approach.step(run);
    if (nowUs % LOOK_US !== 0) return;
    const { verdict } = run;
    const reached =
      verdict === null ? 0 : verdict.checkpoints.passed + verdict.targets.reached + verdict.blocks.delivered;
    const square =
      pose === null ? '' : `${String(Math.round(pose.xMm / SQUARE_MM))} ${String(Math.round(pose.yMm / SQUARE_MM))}`;
    if (reached > this.reached || !this.squares.has(square)) this.newUs = nowUs;
    this.squares.add(square);
    this.reached = Math.max(this.reached, reached);
    const { leftUs } = this.approach;
    const isLost = leftUs !== null && nowUs - leftUs > STALL_US;
    this.isStalled = isLost || nowUs - this.newUs > (this.comesAgain ? ROUNDS_US : STALL_US);
  }
}

/** How far a run got: each check that holds is worth more than any place. */
export const scoreOf = ({ score }: Stall, { held }: WorldResult): number => score + held.length * HELD_MM;

const HELD_MM = 10_000_000;

/** A place reached is worth more than any distance. */
const REACHED_MM = 100_000;
