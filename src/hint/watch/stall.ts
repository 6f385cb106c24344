import type { WorldResult } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { Approach } from '#check/run/approach';
import type { Pose } from '#core/geometry';
import { solidParts } from '#scene/kinds/index';
import type { Onlooker } from '#check/run/run-world';
import type { Simulation } from '#simulation/simulation';
import { isStill } from './still';

/** Simulated time between two looks. Chosen: a robot at full speed drives some centimetres. */
const LOOK_US = 100_000;
/** Side of the squares by which a place counts as new, in mm. Chosen: half a robot. */
const SQUARE_MM = 50;
/**
 * Simulated time without a new place after which nothing comes of a run. Chosen: longer than a turn on the spot, or a push
 * against a wall.
 */
const STALL_US = 5_000_000;
/** The same for a robot that stands with its motors off. Chosen: longer than it has to wait for a gate. */
const WAIT_US = 10_000_000;
/** The same where places come again. */
const ROUNDS_US = 30_000_000;
/** The same away from the line that was left: where nothing stands that a robot may drive round, and elsewhere. */
const [LOST_US, ROUND_US] = [5_000_000, 10_000_000];

/** How many times as long as a try a run is looked at that is told about. */
export const PATIENCE = 2;

/** Gives up a run in which nothing new happens any more, and measures how far it got. */
export class Stall implements Onlooker {
  private readonly approach: Approach;
  private readonly squares = new Set<string>();
  private newUs = 0;
  private reached = 0;
  private isStalled = false;
  private lastUs = 0;
  private last: Pose | null = null;
  /** True if it has stood with its motors off since the last new place. */
  private waits = false;
  private readonly lostUs: number;

  /** True for a task in which places are reached several times. */
  private readonly comesAgain: boolean;

  /** @param patience how many times as long it waits, where a run is told and not only tried */
  constructor(
    { project, checks }: ClassTask,
    private readonly patience = 1,
  ) {
    this.approach = new Approach(project.scene);
    this.comesAgain = checks.some(({ type }) => type === 'laps');
    const isFree = project.scene.objects.every((one) => solidParts(one).length === 0);
    this.lostUs = isFree ? LOST_US : ROUND_US;
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
    if (reached > this.reached || !this.squares.has(square)) [this.newUs, this.waits] = [nowUs, false];
    this.squares.add(square);
    this.reached = Math.max(this.reached, reached);
    this.waits ||= isStill(pose, this.last) && isOff(run);
    this.last = pose;
    const { leftUs } = this.approach;
    const isLost = leftUs !== null && nowUs - leftUs > this.patience * this.lostUs;
    this.isStalled = isLost || nowUs - this.newUs > this.patience * this.stallUs;
  }

  private get stallUs(): number {
    if (this.comesAgain) return ROUNDS_US;
    return this.waits ? WAIT_US : STALL_US;
  }
}

/** True while the motors of the first robot are off. */
function isOff(run: Simulation): boolean {
  const duty = run.snapshot().robot?.state.duty;
  return duty === undefined || (duty.left === 0 && duty.right === 0);
}

/** How far a run got: each check that holds is worth more than any place. */
export const scoreOf = ({ score }: Stall, { held }: WorldResult): number => score + held.length * HELD_MM;

const HELD_MM = 10_000_000;

/** A place reached is worth more than any distance. */
const REACHED_MM = 100_000;
