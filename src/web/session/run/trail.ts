/**
 * Maximum number of points. Chosen: with one every 4 mm that is 260 m, a quarter of an hour at full speed, in 512 kB.
 */
const MOST_POINTS = 65_536;

/** The robot's path in a run, oldest point first; grows with the run and forgets its oldest quarter when it is full. */
export class Trail {
  /** x and y in mm alternately; two `NaN` where the hand lifted the robot. Only the first 2 · `count` are to be seen. */
  xyMm = new Float32Array(512);
  count = 0;
  /** Changes whenever points were dropped or hidden: drawings made from them are then outdated. */
  generation = 0;
  /** Number of points, those that are not to be seen included. */
  private kept = 0;
  /** Number of points at each time when some were added. */
  private ages: { readonly timeUs: number; readonly points: number }[] = [];
  private untilUs: number | null = null;

  /** Adds points in the form of a snapshot: x and y alternately. */
  add(xyMm: readonly number[], timeUs = 0): void {
    const added = Math.min(xyMm.length / 2, MOST_POINTS / 2);
    if (added === 0) return;
    if (this.kept + added > MOST_POINTS) this.forget(Math.max(MOST_POINTS / 4, added));
    if (2 * (this.kept + added) > this.xyMm.length) {
      const larger = new Float32Array(Math.max(2 * this.xyMm.length, 4 * added));
      larger.set(this.xyMm.subarray(0, 2 * this.kept));
      this.xyMm = larger;
    }
    this.xyMm.set(xyMm.slice(xyMm.length - 2 * added), 2 * this.kept);
    this.kept += added;
    this.ages.push({ timeUs, points: this.kept });
    if (this.untilUs === null) this.count = this.kept;
  }

  /** Shows it as far as it went at a moment; `null`: all of it. */
  lookAt(timeUs: number | null): void {
    this.untilUs = timeUs;
    const count = timeUs === null ? this.kept : (this.ages.findLast((age) => age.timeUs <= timeUs)?.points ?? 0);
    if (count < this.count) this.generation += 1;
    this.count = count;
  }

  clear(): void {
    this.count = this.kept = 0;
    this.ages = [];
    this.untilUs = null;
    this.generation += 1;
    this.xyMm = new Float32Array(512);
  }

  private forget(points: number): void {
    this.xyMm.copyWithin(0, 2 * points, 2 * this.kept);
    this.kept -= points;
    this.count = Math.max(0, this.count - points);
    this.ages = this.ages.flatMap((age) => (age.points > points ? [{ ...age, points: age.points - points }] : []));
    this.generation += 1;
  }
}
