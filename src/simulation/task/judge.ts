import { exactCos, exactSin } from '#core/exact-math';
import type { Pose, Vec } from '#core/geometry';
import { zoneHolds, zoneOverlaps } from '#scene/kinds/zone';
import { lengthOf, movedOutline, type Outline } from '#scene/outline';
import { helps, type Help, type Scene, type Task, type Zone } from '#scene/scene';
import type { Chassis } from '#world/chassis';
import type { BlockHandle } from '#world/shapes';
import { changesRun } from '../at-once';
import { createDeliveries, isSame, type Deliveries } from './deliveries';
import { briefOf, hasGoal, isTask, type TaskBrief } from './task-brief';
import type { EarlyArrival, Verdict } from './verdict';

/** The judge's view of the run. */
export interface Watched {
  readonly chassis: Pick<Chassis, 'pose' | 'collisions' | 'touching'>;
  /** Convex parts of the robot's body at its size, robot frame, mm. */
  readonly body: readonly Outline[];
  /** The movable block of this id, or `undefined` if the run has no such block. */
  readonly block: (id: string) => BlockHandle | undefined;
  /** Ids of the obstacles in the run that must never be touched: spikes, and movers with spikes. */
  readonly spiked: ReadonlySet<string>;
}

/** Why a task is failed. */
type Failure = Pick<Verdict, 'reason' | 'by'>;

/**
 * Decides whether the task of a course is done.
 *
 * - The robot reaches a zone when the middle of its axle is inside. Checkpoints count in the order of their numbers
 *   (those of one number in any order), targets for the robot only after all checkpoints.
 * - A block is delivered while all its corners are in a target that wants blocks and no robot holds it.
 * - *Passed*: all checkpoints, all targets, and all blocks at the same time. A task with only a time limit is passed
 *   when the time is over: holding out was the task. Without even that, it stays open.
 * - *Failed*: a part of the robot's body is over a forbidden zone; it touches spikes; with `noTouch` it touches
 *   anything solid (except blocks, if blocks are to be delivered); the time is over. If a task passes and fails in the
 *   same step, it has failed.
 * - *Helped*: what would have been passed, had neither the hand moved anything nor the course been edited. Help that the
 *   task allows is told, and it is passed.
 */
export class Judge {
  private brief: TaskBrief;
  private deliveries: Deliveries;
  /** Ids of the zones that the robot has reached. */
  private readonly reached = new Set<string>();
  private readonly help = new Set<Help>();
  private early: EarlyArrival | null = null;
  /** Ids of the zones in which the robot is before their turn; `null` before the first look. */
  private waiting: ReadonlySet<string> | null = null;
  private delivered = 0;
  private touches = 0;
  private lastPose: Pose | null = null;
  private final: Verdict | null = null;
  private forbidden: readonly Forbidden[];

  constructor(
    private course: Scene,
    private readonly watched: Watched,
  ) {
    this.brief = briefOf(course);
    this.forbidden = forbiddenIn(this.brief, watched.body);
    this.deliveries = createDeliveries(this.brief, watched.block);
  }

  /** Uses another course from now on. What was reached stays reached, and a decision stays. */
  take(course: Scene): void {
    if (changesRun(this.course, course)) this.help.add('edits');
    this.course = course;
    if (!this.isAsked()) this.touches = this.watched.chassis.collisions();
    this.brief = briefOf(course);
    this.forbidden = forbiddenIn(this.brief, this.watched.body);
    this.deliveries = createDeliveries(this.brief, this.watched.block);
    this.lastPose = null;
    this.waiting = null;
    if (this.early !== null && this.numberOf(this.early.id) !== this.early.number) this.early = null;
  }

  /** The hand has moved the robot or a block. */
  takeHand(): void {
    this.help.add('hand');
  }

  /** The state of the task, or `null` if the course has none. */
  verdict(): Verdict | null {
    return this.final ?? (this.isAsked() ? this.openVerdict() : null);
  }

  /** The task is open, and time alone will decide it. */
  get awaitsTime(): boolean {
    return this.final === null && this.isAsked() && this.brief.task.seconds !== null;
  }

  /** Call it before the first step of the world and after each, at simulated time `timeUs`. */
  step(timeUs: number): void {
    if (this.final !== null || !this.isAsked()) return;
    const { brief } = this;
    const pose = this.watched.chassis.pose();
    const hasMoved = this.lastPose === null || !isSame(pose, this.lastPose);
    this.lastPose = pose;
    if (hasMoved) this.reach(pose);
    if (brief.blockTargets.length > 0) this.delivered = this.deliveries.count();
    const failure = this.newTouch() ?? (hasMoved ? this.overForbidden(pose) : null);
    const { seconds } = brief.task;
    const isLate = seconds !== null && timeUs >= seconds * 1_000_000;
    if (failure !== null) this.decide('failed', timeUs, failure);
    else if (hasGoal(brief)) {
      if (this.isDone()) this.pass(timeUs);
      else if (isLate) this.decide('failed', timeUs, { reason: 'time', by: null });
    } else if (isLate) this.pass(timeUs);
  }

  private isAsked(): boolean {
    return this.watched.spiked.size > 0 || isTask(this.brief);
  }

  private openVerdict(): Verdict {
    const { checkpoints, robotTargets, blocksWanted } = this.brief;
    return {
      state: 'open',
      atMs: null,
      reason: null,
      by: null,
      place: null,
      help: helps.filter((one) => this.help.has(one)),
      early: this.early,
      checkpoints: { passed: this.countReached(checkpoints), of: checkpoints.length },
      targets: { reached: this.countReached(robotTargets), of: robotTargets.length },
      blocks: { delivered: this.delivered, of: blocksWanted },
      stars: this.brief.task.stars === undefined ? null : 0,
      touches: this.watched.chassis.collisions(),
    };
  }

  private pass(timeUs: number): void {
    const { allows = [] } = this.brief.task;
    const isOwn = [...this.help].every((one) => allows.includes(one));
    this.decide(isOwn ? 'passed' : 'helped', timeUs);
  }

  private decide(
    state: Exclude<Verdict['state'], 'open'>,
    timeUs: number,
    failure: Failure = { reason: null, by: null },
  ): void {
    const { xMm, yMm } = this.watched.chassis.pose();
    const place = { xMm: tenths(xMm), yMm: tenths(yMm) };
    const stars = state === 'passed' ? starsWithin(this.brief.task.stars, timeUs) : {};
    this.final = { ...this.openVerdict(), ...failure, state, atMs: timeUs / 1000, place, ...stars };
  }

  private isDone(): boolean {
    const { checkpoints, robotTargets, blocksWanted } = this.brief;
    const isReached = ({ id }: Zone): boolean => this.reached.has(id);
    return checkpoints.every(isReached) && robotTargets.every(isReached) && this.delivered === blocksWanted;
  }

  private countReached(zones: readonly Zone[]): number {
    return zones.reduce((sum, { id }) => (this.reached.has(id) ? sum + 1 : sum), 0);
  }

  private reach(pose: Pose): void {
    const at = { x: pose.xMm, y: pose.yMm };
    /** The number of the next checkpoint. */
    let next = Infinity;
    for (const zone of this.brief.checkpoints) {
      if (this.reached.has(zone.id)) continue;
      if (zone.number > next) break;
      if (zoneHolds(zone, at)) this.arrive(zone);
      else next = zone.number;
    }
    if (next === Infinity) for (const zone of this.brief.robotTargets) if (zoneHolds(zone, at)) this.arrive(zone);
    this.noteEarly(at, next);
  }

  private arrive({ id }: Zone): void {
    this.reached.add(id);
    if (this.early?.id === id) this.early = null;
  }

  /** Notes a place that the robot enters before its turn. Where it stands from the start, it has not come to. */
  private noteEarly(at: Vec, next: number): void {
    const inside = next === Infinity ? [] : this.later(next).filter((zone) => zoneHolds(zone, at));
    const entered = this.waiting === null ? [] : inside.filter(({ id }) => this.waiting?.has(id) !== true);
    const [first] = entered;
    if (first !== undefined) this.early = { id: first.id, number: first.number, before: next };
    this.waiting = inside.length === 0 ? NOWHERE : new Set(inside.map(({ id }) => id));
  }

  /** The zones after the checkpoint of this number. */
  private later(next: number): readonly Zone[] {
    const { checkpoints, robotTargets } = this.brief;
    const isLater = ({ id, number }: Zone): boolean => number > next && !this.reached.has(id);
    return [...checkpoints.filter(isLater), ...robotTargets];
  }

  /** The number of a checkpoint, 0 for a target, `undefined` for what is not there. */
  private numberOf(id: string): number | undefined {
    const { checkpoints, robotTargets } = this.brief;
    return [...checkpoints, ...robotTargets].find((zone) => zone.id === id)?.number;
  }

  /** Touched things are looked up only when a touch has begun. */
  private newTouch(): Failure | null {
    const { chassis, spiked } = this.watched;
    const touches = chassis.collisions();
    if (touches === this.touches) return null;
    this.touches = touches;
    const touching = chassis.touching();
    const spikes = touching.find((id) => id !== null && spiked.has(id));
    if (spikes !== undefined) return { reason: 'spikes', by: spikes };
    if (!this.brief.task.noTouch) return null;
    const by = touching.filter((id) => !this.brief.blocks.some((block) => block.id === id)).at(-1);
    return by === undefined ? null : { reason: 'touched', by };
  }

  private overForbidden(pose: Pose): Failure | null {
    const { xMm: x, yMm: y, headingRad } = pose;
    let parts: readonly Outline[] | null = null;
    for (const { zone, atX, atY, reachSquared } of this.forbidden) {
      if ((x - atX) * (x - atX) + (y - atY) * (y - atY) > reachSquared) continue;
      const direction = { x: exactCos(headingRad), y: exactSin(headingRad) };
      parts ??= this.watched.body.map((part) => movedOutline(part, { x, y }, direction));
      if (parts.some((part) => zoneOverlaps(zone, part))) return { reason: 'forbidden', by: zone.id };
    }
    return null;
  }
}

/** One star for passing, and one for each time that was kept, in whichever order the two are given. */
function starsWithin(times: Task['stars'], timeUs: number): Pick<Verdict, 'stars'> {
  return { stars: times === undefined ? null : 1 + times.filter((seconds) => timeUs <= seconds * 1_000_000).length };
}

const tenths = (mm: number): number => Math.round(mm * 10) / 10;

const NOWHERE: ReadonlySet<string> = new Set();

/** A forbidden zone, and the distance within which the robot can be over it. */
interface Forbidden {
  readonly zone: Zone;
  readonly atX: number;
  readonly atY: number;
  readonly reachSquared: number;
}

function forbiddenIn({ forbidden }: TaskBrief, body: readonly Outline[]): readonly Forbidden[] {
  const bodyReach = Math.max(0, ...body.flat().map(({ x, y }) => lengthOf(x, y)));
  return forbidden.map((zone) => {
    const reach = bodyReach + lengthOf(zone.size[0], zone.size[1]) / 2;
    return { zone, atX: zone.at[0], atY: zone.at[1], reachSquared: reach * reach };
  });
}
