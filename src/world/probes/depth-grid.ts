import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { Obstacle } from './distance-cone';

/**
 * The view of a multizone ranger: cells in rows and columns, each with one ray through its middle. Directions are tangents
 * of angles from the axis, so that depths along the axis follow from them without trigonometry.
 */
export interface DepthView {
  /** Height of the lens above the floor, which the axis keeps. */
  readonly heightMm: number;
  /** From the left (positive) to the right. */
  readonly columns: readonly number[];
  /** From the top (positive) down. */
  readonly rows: readonly number[];
  /** Greatest depth. */
  readonly rangeMm: number;
  /** A row sees the floor if it looks down at least this steeply (tangent, above 0). */
  readonly leastFloorSlope: number;
}

/** The sight of one cell. */
export interface DepthCell {
  /** Along the axis, 0 … the range; `Infinity`: nothing is in range. A flat wall across the axis gives all cells the same. */
  readonly depthMm: number;
  readonly isFloor: boolean;
}

/** The depths between which the vertical plane of a column runs through an obstacle. */
interface Crossing {
  readonly nearMm: number;
  readonly farMm: number;
  readonly heightMm: number;
}

const NOTHING: DepthCell = { depthMm: Infinity, isFloor: false };

/**
 * The cells of a view row by row, from the upper left. A cell sees the nearest thing on its ray, which may be the front or
 * the top of an obstacle, or the floor.
 */
export function depthGrid(
  from: Vec,
  headingRad: number,
  view: DepthView,
  obstacles: Iterable<Obstacle>,
): readonly DepthCell[] {
  const crossings = view.columns.map((): Crossing[] => []);
  const cos = exactCos(headingRad);
  const sin = exactSin(headingRad);
  for (const obstacle of obstacles) {
    const pose = obstacle.pose();
    const x = (pose.xMm - from.x) * cos + (pose.yMm - from.y) * sin;
    const y = (pose.yMm - from.y) * cos - (pose.xMm - from.x) * sin;
    if (x < -obstacle.radiusMm || x > view.rangeMm + obstacle.radiusMm) continue;
    const corners = cornersIn(obstacle, x, y, pose.headingRad - headingRad);
    for (const [column, slope] of view.columns.entries()) {
      const span = corners === null ? acrossCircle(x, y, obstacle.radiusMm, slope) : acrossPolygon(corners, slope);
      if (span !== null) crossings[column]?.push({ ...span, heightMm: obstacle.heightMm });
    }
  }
  return view.rows.flatMap((rise) => crossings.map((column) => seen(view, rise, column)));
}

/** The corners of an obstacle in the view's frame; `null` for a circle. */
function cornersIn({ cornersMm }: Obstacle, x: number, y: number, turnRad: number): readonly Vec[] | null {
  if (cornersMm.length === 0) return null;
  const cos = exactCos(turnRad);
  const sin = exactSin(turnRad);
  return cornersMm.map((corner) => ({
    x: x + corner.x * cos - corner.y * sin,
    y: y + corner.x * sin + corner.y * cos,
  }));
}

type Span = Pick<Crossing, 'nearMm' | 'farMm'>;

/** The part of the line y = slope · x that lies in a convex polygon (counter-clockwise) and ahead of the lens. */
function acrossPolygon(corners: readonly Vec[], slope: number): Span | null {
  let nearMm = 0;
  let farMm = Infinity;
  let a = corners[corners.length - 1] ?? { x: 0, y: 0 };
  for (const b of corners) {
    const dx = b.x - a.x;
    const dy = b.y - a.y;
    // Inside is where grows · x + before ≥ 0.
    const grows = dx * slope - dy;
    const before = dy * a.x - dx * a.y;
    if (grows > 0) nearMm = Math.max(nearMm, -before / grows);
    else if (grows < 0) farMm = Math.min(farMm, -before / grows);
    else if (before < 0) return null;
    a = b;
  }
  return nearMm < farMm ? { nearMm, farMm } : null;
}

/** The same for a circle. */
function acrossCircle(x: number, y: number, radius: number, slope: number): Span | null {
  const squared = 1 + slope * slope;
  const middle = (x + slope * y) / squared;
  const half = middle * middle - (x * x + y * y - radius * radius) / squared;
  if (half <= 0) return null;
  const root = Math.sqrt(half);
  const span = { nearMm: Math.max(middle - root, 0), farMm: middle + root };
  return span.nearMm < span.farMm ? span : null;
}

/** The nearest thing that a ray meets which rises (or falls) by `rise` per mm of depth. */
function seen({ heightMm, rangeMm, leastFloorSlope }: DepthView, rise: number, column: readonly Crossing[]): DepthCell {
  let depthMm = Infinity;
  for (const { nearMm, farMm, heightMm: top } of column) {
    // A falling ray passes above a low thing until it is down at its top; a rising ray that is above never comes back.
    const metMm = rise < 0 ? Math.max(nearMm, (heightMm - top) / -rise) : nearMm;
    if (metMm < farMm && (rise < 0 || heightMm + rise * metMm <= top)) depthMm = Math.min(depthMm, metMm);
  }
  const floorMm = -rise >= leastFloorSlope ? heightMm / -rise : Infinity;
  if (Math.min(depthMm, floorMm) > rangeMm) return NOTHING;
  return floorMm < depthMm ? { depthMm: floorMm, isFloor: true } : { depthMm, isFloor: false };
}
