import type { Vec } from '#core/geometry';

/** Corners of a convex outline, counter-clockwise. The functions here take any unit that both outlines share. */
export type Polygon = readonly Vec[];

/** The relative position of two outlines. */
export interface Gap {
  /** Distance from face to face, negative when they overlap; from corner to corner less than the true distance. */
  readonly gap: number;
  /** Direction from the first to the second outline, length 1. */
  readonly normal: Vec;
}

/** Corners this close to the nearest one lie on the same face. In the engine's units: 0.4 mm, the reach of its skin. */
const SAME_FACE = 0.02;

/** The gap between two outlines, along the direction in which they are farthest apart (separating axes). */
export function gapBetween(a: Polygon, b: Polygon): Gap {
  const ofA = widestGap(a, b);
  const ofB = widestGap(b, a);
  if (ofB.gap > ofA.gap) return { gap: ofB.gap, normal: { x: -ofB.normal.x, y: -ofB.normal.y } };
  return ofA;
}

/** The widest gap along the normals of the first outline. */
function widestGap(a: Polygon, b: Polygon): Gap {
  let gap = -Infinity;
  let normal: Vec = { x: 1, y: 0 };
  let from = a[a.length - 1] ?? normal;
  for (const to of a) {
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    const length = Math.sqrt(dx * dx + dy * dy);
    const x = dy / length;
    const y = -dx / length;
    let nearest = Infinity;
    for (const corner of b) nearest = Math.min(nearest, (corner.x - from.x) * x + (corner.y - from.y) * y);
    if (nearest > gap) {
      gap = nearest;
      normal = { x, y };
    }
    from = to;
  }
  return { gap, normal };
}

/** The point where the first outline touches the second: the middle of the faces along the normal. */
export function touchPoint(a: Polygon, b: Polygon, normal: Vec): Vec {
  const faceOfA = faceSpan(a, { x: normal.x, y: normal.y });
  const faceOfB = faceSpan(b, { x: -normal.x, y: -normal.y });
  // The tangent of the second face points in the opposite direction.
  const along = (Math.max(faceOfA.from, -faceOfB.to) + Math.min(faceOfA.to, -faceOfB.from)) / 2;
  const out = -faceOfB.out;
  return { x: normal.x * out - normal.y * along, y: normal.y * out + normal.x * along };
}

/** The corners farthest out along a normal: their distance, and their extent along the tangent. */
function faceSpan(polygon: Polygon, normal: Vec): { readonly out: number; readonly from: number; readonly to: number } {
  let out = -Infinity;
  for (const { x, y } of polygon) out = Math.max(out, x * normal.x + y * normal.y);
  let from = Infinity;
  let to = -Infinity;
  for (const { x, y } of polygon) {
    if (x * normal.x + y * normal.y < out - SAME_FACE) continue;
    const along = y * normal.x - x * normal.y;
    from = Math.min(from, along);
    to = Math.max(to, along);
  }
  return { out, from, to };
}

/** Whether a point lies inside an outline or on its edge. */
export function isInside(polygon: Polygon, point: Vec): boolean {
  let from = polygon[polygon.length - 1] ?? point;
  for (const to of polygon) {
    if ((to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x) < 0) return false;
    from = to;
  }
  return true;
}
