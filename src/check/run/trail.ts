import type { Point } from '#scene/scene';
import type { TrailPoint } from '#simulation/trail';
import type { WorldResult } from '../result';

/** Most points of a trail. Chosen: smooth in a drawing as large as a hand, 2 kB in a file. */
const MOST_POINTS = 300;

/** A point of a trail, and the simulated time (ms) at which the robot was there. */
interface Passed {
  readonly at: Point;
  readonly ms: number;
}

/** Records a trail with a bounded number of points: the longer it becomes, the greater their spacing. */
export class TrailKeeper {
  private pieces: Passed[][] = [[]];
  private count = 0;
  private every = 1;
  private skipped = 0;

  /** @param point `null`: the hand has lifted the robot */
  add(point: TrailPoint, timeUs: number): void {
    if (point === null) {
      if (this.pieces.length < MOST_POINTS) this.pieces.push([]);
      this.skipped = 0;
      return;
    }
    this.skipped -= 1;
    if (this.skipped > 0) return;
    this.skipped = this.every;
    this.pieces.at(-1)?.push({ at: [Math.round(point.x), Math.round(point.y)], ms: Math.round(timeUs / 1000) });
    this.count += 1;
    if (this.count > MOST_POINTS) this.thin();
  }

  /** The trail so far, with its times. */
  way(): Pick<WorldResult, 'trail' | 'trailMs'> {
    const pieces = this.pieces.filter(({ length }) => length > 0);
    return {
      trail: pieces.map((piece) => piece.map(({ at }) => at)),
      trailMs: pieces.map((piece) => piece.map(({ ms }) => ms)),
    };
  }

  private thin(): void {
    this.pieces = this.pieces.map((piece) => piece.filter((_, place) => place % 2 === 0));
    this.count = this.pieces.reduce((sum, { length }) => sum + length, 0);
    this.every *= 2;
  }
}
