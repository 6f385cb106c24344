import type { Vec } from '#core/geometry';

/** A stroke on the floor. */
export interface Painted {
  readonly halfWidth: number;
  readonly reflectance: number;
  /** Strokes on higher layers cover those below. */
  layer: number;
}

/** A straight piece of a stroke: all places within half a width of a line. */
export interface Segment {
  readonly ax: number;
  readonly ay: number;
  /** Direction from a, of length 1; along x for a dot. */
  readonly ex: number;
  readonly ey: number;
  /** 0 for a dot. */
  readonly length: number;
  readonly painted: Painted;
  /** The last query that found it: it lies in several cells. */
  seen: number;
}

/** The pieces of a stroke; a single point is a dot. */
export function segmentsOf(points: readonly Vec[], painted: Painted): Segment[] {
  const segments: Segment[] = [];
  points.forEach((to, index) => {
    const from = points[index - 1] ?? to;
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    const length = Math.sqrt(dx * dx + dy * dy);
    const [ex, ey] = length > 0 ? [dx / length, dy / length] : [1, 0];
    if (length > 0 || points.length === 1) segments.push({ ax: from.x, ay: from.y, ex, ey, length, painted, seen: 0 });
  });
  const [first] = points;
  // Points that are all equal also leave a dot.
  if (segments.length === 0 && first)
    segments.push({ ax: first.x, ay: first.y, ex: 1, ey: 0, length: 0, painted, seen: 0 });
  return segments;
}

/** Square of the distance of a place from the middle line of a piece. */
export function distanceSquared({ ax, ay, ex, ey, length }: Segment, x: number, y: number): number {
  const along = (x - ax) * ex + (y - ay) * ey;
  const across = (y - ay) * ex - (x - ax) * ey;
  const beyond = along < 0 ? along : along > length ? along - length : 0;
  return across * across + beyond * beyond;
}
