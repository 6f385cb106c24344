import type { Vec } from '#core/geometry';
import { zoneHolds } from '#scene/kinds/zone';
import { distanceToEdge, lengthOf, type Outline } from '#scene/outline';
import type { Scene, Zone } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import { Route } from '#simulation/task/route';
import { briefOf } from '#simulation/task/task-brief';
import { LineWatch } from './line-watch';
import type { Step } from './watcher';

/** Simulated time between two looks at distances. Chosen: a robot at full speed drives less than a centimetre. */
const LOOK_US = 20_000;

/** Measures how near the first robot came to the place that it had to reach next, and when it left the line that leads there. */
export class Approach {
  private readonly route: Route;
  private readonly line: LineWatch;
  private next: readonly Zone[] = [];
  private outlines: readonly Outline[] = [];
  private nearest: number | null = null;
  /** The last place at which it was measured, and how far from there the robot cannot be nearer than it ever was. */
  private measured = { x: 0, y: 0, roomMm: -1 };

  constructor(course: Scene) {
    this.line = new LineWatch(course);
    this.route = new Route(briefOf(course));
  }

  /** Distance of the middle of the axle from the nearest of the places that were next, in mm; `null`: none. */
  get nearestMm(): number | null {
    return this.nearest;
  }

  /** Simulated time at which it left the line, in µs; `null`: it did not. */
  get leftUs(): number | null {
    return this.line.leftUs;
  }

  step({ nowUs, pose }: Step): void {
    if (pose === null) return;
    const at = { x: pose.xMm, y: pose.yMm };
    this.route.pass(at);
    if (nowUs % LOOK_US !== 0) return;
    this.line.look(nowUs, at);
    const { next } = this.route;
    if (next.length !== this.next.length || next.some((zone, place) => zone !== this.next[place])) {
      this.next = next;
      this.outlines = next.map(shapeOutline);
      this.nearest = null;
      this.measured.roomMm = -1;
    }
    const { x, y, roomMm } = this.measured;
    if (lengthOf(at.x - x, at.y - y) >= roomMm) this.measure(at);
  }

  private measure(at: Vec): void {
    let least = Infinity;
    for (const [place, zone] of this.next.entries()) {
      const outline = this.outlines[place];
      const distance = outline === undefined || zoneHolds(zone, at) ? 0 : distanceToEdge(outline, at);
      least = Math.min(least, distance);
    }
    if (this.next.length > 0) this.nearest = Math.min(this.nearest ?? Infinity, least);
    this.measured = { ...at, roomMm: least - (this.nearest ?? Infinity) };
  }
}
