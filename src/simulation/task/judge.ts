import { usOf } from '#core/seconds';
import type { Outline } from '#scene/outline';
import { helps, type Help, type Scene, type Task } from '#scene/scene';
import type { BlockHandle } from '#world/shapes';
import { changesRun } from '../at-once';
import { createDeliveries, type Deliveries } from './deliveries';
import { bodyNow, Entrant, type Failure, type WatchedRobot } from './entrant';
import { LineReferee } from './line-referee';
import { Route } from './route';
import { sharings, type Decision } from './sharing';
import { briefOf, hasGoal, isTask, type TaskBrief } from './task-brief';
import type { Verdict } from './verdict';

/** The judge's view of the run. */
export interface WatchedRun {
  /** At least one; the first counts where the task says nothing of several. */
  readonly robots: readonly WatchedRobot[];
  /** The movable block of this id, or `undefined` if the run has no such block. */
  readonly block: (id: string) => BlockHandle | undefined;
  /** Ids of the obstacles in the run that must never be touched: spikes, and movers with spikes. */
  readonly spiked: ReadonlySet<string>;
}

/**
 * Decides whether the task of a course is done.
 *
 * - A robot reaches a zone when the middle of its axle is inside. Checkpoints count in the order of their numbers
 *   (those of one number in any order), targets for the robot only after all checkpoints.
 * - A block is delivered while all its corners are in a target that wants blocks and no robot holds it.
 * - *Passed*: all checkpoints, all targets, and all blocks at the same time. A task with only a time limit is passed
 *   when the time is over: holding out was the task. Without even that, it stays open.
 * - *Failed*: any part of the robot, also what is fixed to it or held, is over a forbidden zone; it touches spikes; with `noTouch` it touches
 *   anything solid (except blocks, if blocks are to be delivered); the time is over. If a task passes and fails in the
 *   same step, it has failed.
 * - *Helped*: it would have been passed, had neither the hand moved anything nor the course been edited. Help that the
 *   task allows is only reported: the task is passed.
 * - A line that is scored (`Scene.league`) is passed when the first robot has come to its end, whatever its points.
 * - How several robots share it: `Task.robots`, and `sharing.ts`.
 */
export class Judge {
  private brief: TaskBrief;
  private deliveries: Deliveries;
  /** The robots that count. */
  private entrants: readonly Entrant[];
  private readonly help = new Set<Help>();
  private delivered = 0;
  private final: Verdict | null = null;
  private referee: LineReferee | null;

  constructor(
    private course: Scene,
    private readonly watched: WatchedRun,
  ) {
    this.brief = briefOf(course);
    this.deliveries = createDeliveries(this.brief, watched.block);
    this.entrants = this.enter();
    this.referee = this.refereeOf(course);
  }

  /**
   * Uses another course from now on. What was reached stays reached, unless the robots share the task in another way
   * now; a decision stays.
   */
  take(course: Scene): void {
    if (changesRun(this.course, course)) this.help.add('edits');
    const wasAsked = this.isAsked();
    const wasShared = this.course.task.robots;
    this.course = course;
    this.brief = briefOf(course);
    this.deliveries = createDeliveries(this.brief, this.watched.block);
    if (course.task.robots !== wasShared) this.entrants = this.enter();
    else for (const entrant of this.entrants) entrant.take(this.brief);
    if (this.referee?.fits(course) === true) this.referee.take(course);
    else this.referee = this.refereeOf(course);
    if (!wasAsked || course.task.robots !== wasShared) for (const entrant of this.entrants) entrant.forgetTouches();
  }

  /** The hand has moved the robot or a block. */
  takeHand(): void {
    this.help.add('hand');
  }

  /** A lack of progress is called: the robot begins anew at the last checkpoint, if its line is scored. */
  callLack(): void {
    if (this.final === null) this.referee?.call();
  }

  /** The state of the task, or `null` if the course has none. */
  verdict(): Verdict | null {
    return this.final ?? (this.isAsked() ? this.openVerdict() : null);
  }

  /** True once it has decided: its verdict stays. */
  get isFinal(): boolean {
    return this.final !== null;
  }

  /** Number of touches of walls, blocks, the edge or obstacles up to now, also after the decision, of all robots that count. */
  get touches(): number {
    return this.entrants.reduce((sum, { collisions }) => sum + collisions, 0);
  }

  /** Convex outlines of the first robot now, with all that is fixed to it or held; world mm. */
  body(): readonly Outline[] {
    return this.watched.robots.slice(0, 1).flatMap(bodyNow);
  }

  /** True while the task is open and has a time limit, which will decide it at the latest. */
  get awaitsTime(): boolean {
    return this.final === null && this.isAsked() && this.brief.task.seconds !== null;
  }

  /** Call it before the first step of the world and after each, at simulated time `timeUs`. */
  step(timeUs: number): void {
    if (this.final !== null || !this.isAsked()) return;
    const { task, blockTargets, blocksWanted, ring } = this.brief;
    const failures = this.look();
    this.referee?.step(timeUs);
    if (blockTargets.length > 0) this.delivered = this.deliveries.count();
    const decision = sharings[task.robots ?? 'one']({
      timeUs,
      entrants: this.entrants,
      failures,
      areDelivered: this.delivered === blocksWanted && this.referee?.isDone !== false,
      hasGoal: hasGoal(this.brief),
      isLate: task.seconds !== null && timeUs >= usOf(task.seconds),
      ring,
    });
    if (decision !== null) this.decide(decision, timeUs);
  }

  /** The robots that count, at the beginning of their ways. */
  private enter(): readonly Entrant[] {
    const { robots } = this.course.task;
    const counted = robots === undefined ? this.watched.robots.slice(0, 1) : this.watched.robots;
    const together = robots === 'together' ? new Route(this.brief) : null;
    return counted.map(
      (robot) => new Entrant(robot, this.brief, together ?? new Route(this.brief), this.watched.spiked),
    );
  }

  private refereeOf({ league, objects }: Scene): LineReferee | null {
    const [robot] = this.watched.robots;
    return league && robot ? new LineReferee(league, { objects }, robot, this.watched.block) : null;
  }

  private isAsked(): boolean {
    return this.watched.spiked.size > 0 || isTask(this.brief);
  }

  /** The failures of the entrants that are still open at this moment. */
  private look(): ReadonlyMap<Entrant, Failure> {
    let failures: Map<Entrant, Failure> | null = null;
    for (const entrant of this.entrants) {
      const seen = entrant.isOpen ? entrant.look() : null;
      const failure = seen && this.withOtherRobot(entrant, seen);
      if (failure !== null) (failures ??= new Map()).set(entrant, failure);
    }
    return failures ?? NOTHING;
  }

  /**
   * Handles contact with something that has no name: another robot is named, or may be touched where that is the
   * task.
   */
  private withOtherRobot(entrant: Entrant, failure: Failure): Failure | null {
    if (failure.reason !== 'touched' || failure.by !== null) return failure;
    const touched = this.watched.robots.find(({ chassis }) => entrant.isTouching(chassis));
    if (touched === undefined) return failure;
    const { robots } = this.brief.task;
    return robots === 'ring' || robots === 'catch' ? null : { reason: 'robot', by: touched.device };
  }

  private openVerdict(): Verdict {
    const { task, blocksWanted } = this.brief;
    const { entrants } = this;
    return {
      ...{ state: 'open', atMs: null, reason: null, by: null, place: null },
      help: helps.filter((one) => this.help.has(one)),
      early: entrants.map(({ route }) => route.early).find((early) => early !== null) ?? null,
      ...countsOf(entrants, task.robots),
      blocks: { delivered: this.delivered, of: blocksWanted },
      stars: task.stars === undefined ? null : 0,
      touches: this.touches,
      robots: task.robots === undefined ? [] : entrants.map((entrant) => entrant.verdict()),
      ...(this.referee === null ? {} : { points: this.referee.points() }),
    };
  }

  private decide({ state, failure, by }: Decision, timeUs: number): void {
    const { allows = [], stars } = this.brief.task;
    const isOwn = [...this.help].every((one) => allows.includes(one));
    const decided = state === 'passed' && !isOwn ? 'helped' : state;
    this.final = {
      ...this.openVerdict(),
      ...failure,
      state: decided,
      atMs: timeUs / 1000,
      place: by.place(),
      ...(decided === 'passed' ? starsWithin(stars, timeUs) : {}),
    };
  }
}

/** Adds up the robots' own ways; where the first wins, only the farthest counts. A common way counts once. */
function countsOf(entrants: readonly Entrant[], robots: Task['robots']): Pick<Verdict, 'checkpoints' | 'targets'> {
  const counts = (robots === 'together' ? entrants.slice(0, 1) : entrants).map(({ route }) => route.counts());
  const isRace = robots === 'first';
  const joined = isRace ? (values: readonly number[]) => Math.max(...values) : sum;
  const of = isRace ? 1 : counts.length;
  return {
    checkpoints: {
      passed: joined(counts.map(({ checkpoints }) => checkpoints.passed)),
      of: (counts[0]?.checkpoints.of ?? 0) * of,
    },
    targets: { reached: joined(counts.map(({ targets }) => targets.reached)), of: (counts[0]?.targets.of ?? 0) * of },
  };
}

const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);

const NOTHING: ReadonlyMap<Entrant, Failure> = new Map();

/** One star for passing, and one for each time limit that was met, in whichever order the two are given. */
function starsWithin(times: Task['stars'], timeUs: number): Pick<Verdict, 'stars'> {
  return { stars: times === undefined ? null : 1 + times.filter((seconds) => timeUs <= usOf(seconds)).length };
}
