/** Maximum number of points kept. Chosen: with one every 4 mm that is 260 m, a quarter of an hour at full speed, in 512 kB. */
const MOST_POINTS = 65_536;

/** The robot's path in a run, oldest point first; grows with the run and forgets its oldest quarter when it is full. */
export class Trail {
  /** x and y in mm alternately; two `NaN` where the hand lifted the robot. Only the first 2 · `count` are filled. */
  xyMm = new Float32Array(512);
  count = 0;
  /** Changes whenever points were dropped: drawings made from them are then outdated. */
  generation = 0;

  /** Adds points as they come with a snapshot: x and y alternately. */
  add(xyMm: readonly number[]): void {
    const added = Math.min(xyMm.length / 2, MOST_POINTS / 2);
    if (this.count + added > MOST_POINTS) this.forget(Math.max(MOST_POINTS / 4, added));
    if (2 * (this.count + added) > this.xyMm.length) {
      const larger = new Float32Array(Math.max(2 * this.xyMm.length, 4 * added));
      larger.set(this.xyMm.subarray(0, 2 * this.count));
      this.xyMm = larger;
    }
    this.xyMm.set(xyMm.slice(xyMm.length - 2 * added), 2 * this.count);
    this.count += added;
  }

  clear(): void {
    this.count = 0;
    this.generation += 1;
    this.xyMm = new Float32Array(512);
  }

  private forget(points: number): void {
    this.xyMm.copyWithin(0, 2 * points, 2 * this.count);
    this.count -= points;
    this.generation += 1;
  }
}
