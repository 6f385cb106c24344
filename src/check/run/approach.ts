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

/** Most places that wait to be measured: a minute's. More would take memory in long runs. */
const MOST_PLACES = 3000;

/** Measures how near the first robot came to the place that it had to reach next, and when it left the line that leads there. */
export class Approach {
  private readonly route: Route;
  private readonly line: LineWatch;
  private next: readonly Zone[] = [];
  private outlines: readonly Outline[] = [];
  private nearest: number | null = null;
  /** The places since it was last measured, in their order: time, x and y of each. Few are ever asked for: most runs pass. */
  private readonly places: number[] = [];
  /** The last place at which it was measured, and how far from there the robot cannot be nearer than it ever was. */
  private measured = { x: 0, y: 0, roomMm: -1 };

  constructor(course: Scene) {
    this.line = new LineWatch(course);
    this.route = new Route(briefOf(course));
  }

  /** Distance of the middle of the axle from the nearest of the places that were next, in mm; `null`: none. */
  get nearestMm(): number | null {
    this.measureAll();
    return this.nearest;
  }

  /** Simulated time at which it left the line, in µs; `null`: it did not. */
  get leftUs(): number | null {
    this.measureAll();
    return this.line.leftUs;
  }

  step({ nowUs, pose }: Step): void {
    if (pose === null) return;
    const at = { x: pose.xMm, y: pose.yMm };
    this.route.pass(at);
    if (nowUs % LOOK_US !== 0) return;
    const { next } = this.route;
    if (next.length !== this.next.length || next.some((zone, place) => zone !== this.next[place])) {
      this.measureAll();
      this.next = next;
      this.outlines = next.map(shapeOutline);
      this.nearest = null;
      this.measured.roomMm = -1;
    }
    this.places.push(nowUs, at.x, at.y);
    if (this.places.length >= 3 * MOST_PLACES) this.measureAll();
  }

  private measureAll(): void {
    const { places } = this;
    for (let index = 0; index < places.length; index += 3) {
      const [nowUs = 0, x = 0, y = 0] = places.slice(index, index + 3);
      this.line.look(nowUs, { x, y });
      if (lengthOf(x - this.measured.x, y - this.measured.y) >= this.measured.roomMm) this.measure({ x, y });
    }
    places.length = 0;
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
