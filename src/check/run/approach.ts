import { zoneHolds } from '#scene/kinds/zone';
import { distanceToEdge, type Outline } from '#scene/outline';
import type { Scene, Zone } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import { Route } from '#simulation/task/route';
import { briefOf } from '#simulation/task/task-brief';
import type { Step } from './watcher';

/** Simulated time between two looks at distances. Chosen: a robot at full speed drives less than a centimetre. */
const LOOK_US = 20_000;

/** Measures how near the first robot came to the place that it had to reach next. */
export class Approach {
  private readonly route: Route;
  private next: readonly Zone[] = [];
  private outlines: readonly Outline[] = [];
  private nearest: number | null = null;

  constructor(course: Scene) {
    this.route = new Route(briefOf(course));
  }

  /** Distance of the middle of the axle from the nearest of the places that were next, in mm; `null`: none. */
  get nearestMm(): number | null {
    return this.nearest;
  }

  step({ nowUs, pose }: Step): void {
    if (pose === null) return;
    const at = { x: pose.xMm, y: pose.yMm };
    this.route.pass(at);
    if (nowUs % LOOK_US !== 0) return;
    const { next } = this.route;
    if (next.length !== this.next.length || next.some((zone, place) => zone !== this.next[place])) {
      this.next = next;
      this.outlines = next.map(shapeOutline);
      this.nearest = null;
    }
    for (const [place, zone] of next.entries()) {
      const outline = this.outlines[place];
      const distance = outline === undefined || zoneHolds(zone, at) ? 0 : distanceToEdge(outline, at);
      this.nearest = Math.min(this.nearest ?? Infinity, distance);
    }
  }
}
