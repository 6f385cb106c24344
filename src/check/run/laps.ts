import type { Vec } from '#core/geometry';
import { zoneHolds } from '#scene/kinds/zone';
import type { Zone } from '#scene/scene';

/**
 * Counts rounds: all checkpoints in the order of their numbers (those of one number in any order), then all targets, or
 * without a target the zone again with which the first round began. A zone counts again only after it was left.
 */
export class Laps {
  private readonly groups: readonly (readonly Zone[])[];
  private readonly isRing: boolean;
  /** Those of the present group that are done. */
  private readonly reached = new Set<Zone>();
  /** Reached, and not left since. */
  private readonly inside = new Set<Zone>();
  private home: Zone | null = null;
  private place = 0;
  private laps = 0;

  constructor(checkpoints: readonly Zone[], targets: readonly Zone[]) {
    const numbers = [...new Set(checkpoints.map(({ number }) => number))].sort((a, b) => a - b);
    const gates = numbers.map((number) => checkpoints.filter((zone) => zone.number === number));
    this.isRing = targets.length === 0;
    this.groups = this.isRing ? gates : [...gates, targets];
  }

  get count(): number {
    return this.laps;
  }

  /** The robot is here now. */
  visit(at: Vec): void {
    for (const zone of this.inside) if (!zoneHolds(zone, at)) this.inside.delete(zone);
    for (let group = this.next(); group !== null; group = this.next()) {
      for (const zone of group)
        if (!this.reached.has(zone) && !this.inside.has(zone) && zoneHolds(zone, at)) this.arrive(zone);
      if (group.some((zone) => !this.reached.has(zone))) return;
      this.goOn();
    }
  }

  /** The zones that are next; `null`: none. */
  private next(): readonly Zone[] | null {
    return this.groups[this.place] ?? (this.home && [this.home]);
  }

  private arrive(zone: Zone): void {
    this.reached.add(zone);
    this.inside.add(zone);
    this.home ??= zone;
  }

  private goOn(): void {
    this.reached.clear();
    this.place += 1;
    if (this.place < this.groups.length + (this.isRing ? 1 : 0)) return;
    this.laps += 1;
    this.place = 0;
    // Where a ring ends, the next round has begun.
    if (this.isRing && this.home !== null) this.reached.add(this.home);
  }
}
