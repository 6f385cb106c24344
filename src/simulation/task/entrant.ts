import type { Pose } from '#core/geometry';
import { zoneHolds, zoneOverlaps } from '#scene/kinds/zone';
import { lengthOf, type Outline } from '#scene/outline';
import type { Zone } from '#scene/scene';
import type { Chassis } from '#world/chassis';
import { isSame } from './deliveries';
import { outlineAt } from './outline-at';
import type { Route, Waiting } from './route';
import type { TaskBrief } from './task-brief';
import type { RobotVerdict, Verdict } from './verdict';

/** A robot of the run, as the judge sees it. */
export interface WatchedRobot {
  /** Name of its device. */
  readonly device: string;
  readonly chassis: Chassis;
  /** Convex parts of its body at its size, robot frame, mm. */
  readonly body: readonly Outline[];
}

/** Convex outlines of a robot now, with all that is fixed to it or held; world mm. */
export function bodyNow({ chassis, body }: WatchedRobot): readonly Outline[] {
  const pose = chassis.pose();
  return [...body, ...chassis.addedMm()].map((part) => outlineAt(part, pose));
}

/** Why a task is failed. */
export type Failure = Pick<Verdict, 'reason' | 'by'>;

/** Why a robot has failed. */
export type RobotFailure = Pick<RobotVerdict, 'reason' | 'by'>;

/** The state of the task for a robot. */
type Outcome = Pick<RobotVerdict, 'state' | 'atMs' | 'reason' | 'by' | 'place'>;

const OPEN: Outcome = { state: 'open', atMs: null, reason: null, by: null, place: null };

/** One robot with a task: what it has reached, what it touches, and how it ended for it. */
export class Entrant {
  private touches = 0;
  private lastPose: Pose | null = null;
  private waiting: Waiting = null;
  private forbidden: readonly Forbidden[] = [];
  private outcome: Outcome = OPEN;

  /** @param spiked ids of the obstacles in the run that must never be touched */
  constructor(
    private readonly robot: WatchedRobot,
    private brief: TaskBrief,
    readonly route: Route,
    private readonly spiked: ReadonlySet<string>,
  ) {
    this.take(brief);
  }

  /** Uses another course from now on; what has ended stays ended. */
  take(brief: TaskBrief): void {
    this.brief = brief;
    this.route.take(brief);
    this.forbidden = forbiddenIn(brief);
    this.lastPose = null;
    this.waiting = null;
  }

  /** Touches up to now do not count. */
  forgetTouches(): void {
    this.touches = this.robot.chassis.collisions();
  }

  get isOpen(): boolean {
    return this.outcome.state === 'open';
  }

  /** Notes what it has reached since the last look, and returns what it has done wrong. */
  look(): Failure | null {
    const pose = this.robot.chassis.pose();
    const hasMoved = this.lastPose === null || !isSame(pose, this.lastPose);
    this.lastPose = pose;
    if (hasMoved) this.waiting = this.route.visit({ x: pose.xMm, y: pose.yMm }, this.waiting);
    return this.newTouch() ?? this.overForbidden(pose, hasMoved);
  }

  /** True if the middle of its axle is in one of these zones. */
  isIn(zones: readonly Zone[]): boolean {
    const { xMm: x, yMm: y } = this.robot.chassis.pose();
    return zones.some((zone) => zoneHolds(zone, { x, y }));
  }

  /** True if it and this other robot touch. */
  isTouching(other: Chassis): boolean {
    return this.robot.chassis.isTouching(other);
  }

  get chassis(): Chassis {
    return this.robot.chassis;
  }

  pass(timeUs: number): void {
    this.outcome = { ...OPEN, state: 'passed', atMs: timeUs / 1000, place: this.place() };
  }

  fail(failure: RobotFailure, timeUs: number): void {
    this.outcome = { ...failure, state: 'failed', atMs: timeUs / 1000, place: this.place() };
  }

  /** Its place, to a tenth of a mm. */
  place(): NonNullable<Verdict['place']> {
    const { xMm, yMm } = this.robot.chassis.pose();
    return { xMm: tenths(xMm), yMm: tenths(yMm) };
  }

  /** Number of its touches of walls, blocks, the edge or obstacles. */
  get collisions(): number {
    return this.robot.chassis.collisions();
  }

  verdict(): RobotVerdict {
    return { device: this.robot.device, ...this.outcome, ...this.route.counts(), touches: this.collisions };
  }

  /** Touched things are looked up only when a touch has begun. */
  private newTouch(): Failure | null {
    const { chassis } = this.robot;
    const touches = chassis.collisions();
    if (touches === this.touches) return null;
    this.touches = touches;
    const touching = chassis.touching();
    const spikes = touching.find((id) => id !== null && this.spiked.has(id));
    if (spikes !== undefined) return { reason: 'spikes', by: spikes };
    if (!this.brief.task.noTouch) return null;
    const by = touching.filter((id) => !this.brief.blocks.some((block) => block.id === id)).at(-1);
    return by === undefined ? null : { reason: 'touched', by };
  }

  /** @param hasMoved a robot that stands can still move its jaws, or take something up */
  private overForbidden(pose: Pose, hasMoved: boolean): Failure | null {
    if (this.forbidden.length === 0) return null;
    const added = this.robot.chassis.addedMm();
    if (!hasMoved && added.length === 0) return null;
    const { xMm: x, yMm: y } = pose;
    const own = [...this.robot.body, ...added];
    const robotReach = reachOf(own);
    let parts: readonly Outline[] | null = null;
    for (const { zone, atX, atY, reachMm } of this.forbidden) {
      const reach = robotReach + reachMm;
      if ((x - atX) * (x - atX) + (y - atY) * (y - atY) > reach * reach) continue;
      parts ??= own.map((part) => outlineAt(part, pose));
      if (parts.some((part) => zoneOverlaps(zone, part))) return { reason: 'forbidden', by: zone.id };
    }
    return null;
  }
}

const tenths = (mm: number): number => Math.round(mm * 10) / 10;

/** A forbidden zone, and how far from its middle it reaches. */
interface Forbidden {
  readonly zone: Zone;
  readonly atX: number;
  readonly atY: number;
  readonly reachMm: number;
}

const forbiddenIn = ({ forbidden }: TaskBrief): readonly Forbidden[] =>
  forbidden.map((zone) => ({
    ...{ zone, atX: zone.at[0], atY: zone.at[1] },
    reachMm: lengthOf(zone.size[0], zone.size[1]) / 2,
  }));

/** How far from its axle's middle a robot reaches. */
function reachOf(parts: readonly Outline[]): number {
  let squared = 0;
  for (const part of parts) for (const { x, y } of part) squared = Math.max(squared, x * x + y * y);
  return Math.sqrt(squared);
}
