import type { Vec } from '#core/geometry';
import { zoneHolds } from '#scene/kinds/zone';
import type { Zone } from '#scene/scene';
import type { TaskBrief } from './task-brief';
import type { EarlyArrival, Verdict } from './verdict';

/** Ids of the zones in which a robot is before their turn; `null` before its first look. */
export type Waiting = ReadonlySet<string> | null;

/**
 * Which places of a task have been reached: a robot's own way, or that of several robots together. Checkpoints count in
 * the order of their numbers (those of one number in any order), targets only after all checkpoints.
 */
export class Route {
  private readonly reached = new Set<string>();
  private arrival: EarlyArrival | null = null;
  /** The last result of `later`: it is needed with each step, and seldom changes. */
  private found: { readonly next: number; readonly reached: number; readonly zones: readonly Zone[] } | null = null;

  constructor(private brief: TaskBrief) {}

  /** Uses another course from now on. What was reached stays reached. */
  take(brief: TaskBrief): void {
    this.brief = brief;
    this.found = null;
    if (this.arrival !== null && this.numberOf(this.arrival.id) !== this.arrival.number) this.arrival = null;
  }

  /** The last place that was entered before its turn and has not been reached since, or `null`. */
  get early(): EarlyArrival | null {
    return this.arrival;
  }

  /** The places that are next: the checkpoints of one number, or the targets that are left. */
  get next(): readonly Zone[] {
    const isLeft = ({ id }: Zone): boolean => !this.reached.has(id);
    const left = this.brief.checkpoints.filter(isLeft);
    return left.length > 0
      ? left.filter(({ number }) => number === left[0]?.number)
      : this.brief.robotTargets.filter(isLeft);
  }

  get isDone(): boolean {
    const { checkpoints, robotTargets } = this.brief;
    return [checkpoints, robotTargets].every((zones) => zones.every(({ id }) => this.reached.has(id)));
  }

  counts(): Pick<Verdict, 'checkpoints' | 'targets'> {
    const { checkpoints, robotTargets } = this.brief;
    return {
      checkpoints: { passed: this.countReached(checkpoints), of: checkpoints.length },
      targets: { reached: this.countReached(robotTargets), of: robotTargets.length },
    };
  }

  /**
   * Notes the places that a robot has reached at this position, and a place that it has entered before its turn.
   *
   * @param waiting what this returned for the same robot the last time
   */
  visit(at: Vec, waiting: Waiting): Waiting {
    return this.noteEarly(at, this.pass(at), waiting);
  }

  /**
   * Notes the places that a robot has reached at this position, but not those that it enters before their turn.
   *
   * @returns the number of the next checkpoint, `Infinity` when all are reached
   */
  pass(at: Vec): number {
    let next = Infinity;
    for (const zone of this.brief.checkpoints) {
      if (this.reached.has(zone.id)) continue;
      if (zone.number > next) break;
      if (zoneHolds(zone, at)) this.arrive(zone);
      else next = zone.number;
    }
    if (next === Infinity) for (const zone of this.brief.robotTargets) if (zoneHolds(zone, at)) this.arrive(zone);
    return next;
  }

  private arrive({ id }: Zone): void {
    this.reached.add(id);
    if (this.arrival?.id === id) this.arrival = null;
  }

  /** Notes a place that a robot enters before its turn. Places in which it stands from the start do not count. */
  private noteEarly(at: Vec, next: number, waiting: Waiting): Waiting {
    const zones = next === Infinity ? [] : this.later(next);
    if (!zones.some((zone) => zoneHolds(zone, at))) return NOWHERE;
    const inside = zones.filter((zone) => zoneHolds(zone, at));
    const entered = waiting === null ? [] : inside.filter(({ id }) => !waiting.has(id));
    const [first] = entered;
    if (first !== undefined) this.arrival = { id: first.id, number: first.number, before: next };
    return new Set(inside.map(({ id }) => id));
  }

  /** The zones after the checkpoint of this number. */
  private later(next: number): readonly Zone[] {
    const { found, reached } = this;
    if (found?.next === next && found.reached === reached.size) return found.zones;
    const { checkpoints, robotTargets } = this.brief;
    const isLater = ({ id, number }: Zone): boolean => number > next && !reached.has(id);
    const zones = [...checkpoints.filter(isLater), ...robotTargets];
    this.found = { next, reached: reached.size, zones };
    return zones;
  }

  /** The number of a checkpoint, 0 for a target, `undefined` for what is not there. */
  private numberOf(id: string): number | undefined {
    const { checkpoints, robotTargets } = this.brief;
    return [...checkpoints, ...robotTargets].find((zone) => zone.id === id)?.number;
  }

  private countReached(zones: readonly Zone[]): number {
    return zones.reduce((sum, { id }) => (this.reached.has(id) ? sum + 1 : sum), 0);
  }
}

const NOWHERE: ReadonlySet<string> = new Set();
