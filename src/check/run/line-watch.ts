import type { Vec } from '#core/geometry';
import { lengthOf, squaredDistance } from '#scene/outline';
import type { Scene, Stroke } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';

/**
 * Distances of the axle's middle from the edge of a line, in mm. Chosen: sensors lie before the axle, so that a robot that follows
 * a bend swings out by some centimetres; beyond a robot's length none of them sees the line any more.
 */
const [ON_MM, OFF_MM] = [30, 120];
/** Simulated time on the line before it can be left. Chosen: crossing a line is not following it. */
const FOLLOWED_US = 1_000_000;

/** Notes when the first robot left the line that leads to the course's places, for good. */
export class LineWatch {
  private readonly lines: readonly Stroke[];
  private onSinceUs: number | null = null;
  private lastOnUs: number | null = null;
  private offUs: number | null = null;
  /** The last place at which it was measured, and how far from there it cannot have come on or off the line. */
  private measured = { x: 0, y: 0, distanceMm: 0, roomMm: -1 };

  constructor({ objects }: Scene) {
    const lines = objects.filter((one): one is Stroke => one.type === 'stroke');
    const places = objects.flatMap((one) =>
      one.type === 'checkpoint' || one.type === 'target' ? [middleOf(shapeOutline(one))] : [],
    );
    const leads = places.length > 0 && places.every((place) => distanceMm(lines, place) <= ON_MM);
    this.lines = leads ? lines : [];
  }

  /** Simulated time at which it was last on the line, in µs; `null`: it did not leave one. */
  get leftUs(): number | null {
    return this.offUs;
  }

  look(nowUs: number, at: Vec): void {
    if (this.lines.length === 0) return;
    const distance = this.roughDistanceMm(at);
    if (distance <= ON_MM) {
      this.onSinceUs ??= nowUs;
      this.lastOnUs = nowUs;
      this.offUs = null;
    } else if (distance > OFF_MM) {
      const { onSinceUs, lastOnUs } = this;
      if (onSinceUs !== null && lastOnUs !== null && lastOnUs - onSinceUs >= FOLLOWED_US) this.offUs = lastOnUs;
      this.onSinceUs = null;
    }
  }

  /**
   * Distance from the line: that of a place nearby as long as both are on the same side of `ON_MM` and of `OFF_MM`. A step
   * takes the robot a millimetre on, and a line has hundreds of pieces.
   */
  private roughDistanceMm(at: Vec): number {
    const { x, y, roomMm } = this.measured;
    if (lengthOf(at.x - x, at.y - y) >= roomMm) {
      const distance = distanceMm(this.lines, at);
      const room = Math.min(Math.abs(distance - ON_MM), Math.abs(distance - OFF_MM));
      this.measured = { x: at.x, y: at.y, distanceMm: distance, roomMm: room };
    }
    return this.measured.distanceMm;
  }
}

/** Distance of a place from the edge of the nearest line; 0 and less: on it. */
function distanceMm(lines: readonly Stroke[], place: Vec): number {
  let least = Infinity;
  for (const { points, width } of lines)
    for (const [index, [x, y]] of points.entries()) {
      const [fromX, fromY] = points[index - 1] ?? [x, y];
      const squared = squaredDistance(place, { x: fromX, y: fromY }, { x, y });
      least = Math.min(least, Math.sqrt(squared) - width / 2);
    }
  return least;
}

/** The middle of an outline's corners. */
export const middleOf = (outline: readonly Vec[]): Vec => ({
  x: outline.reduce((sum, { x }) => sum + x, 0) / outline.length,
  y: outline.reduce((sum, { y }) => sum + y, 0) / outline.length,
});
