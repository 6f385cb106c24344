import type { Point } from '#scene/scene';

/** Approximate distance of teeth along a side, in mm. Chosen: still teeth, and not dust, on a small picture. */
const PITCH_MM = 34;

/** The outline of a box with teeth around it, about its centre, as the `points` of an SVG polygon: tips lie on the edge. */
export function spikedOutline([width, height]: Point): string {
  const depth = Math.min(14, Math.min(width, height) * 0.3);
  const [x, y] = [width / 2 - depth, height / 2 - depth];
  const points = [
    ...side([-x, -y], [x, -y], [0, -depth]),
    ...side([x, -y], [x, y], [depth, 0]),
    ...side([x, y], [-x, y], [0, depth]),
    ...side([-x, y], [-x, -y], [-depth, 0]),
  ];
  return points.map((point) => point.map(Math.round).join(',')).join(' ');
}

/** From one corner of the inner box towards the next: valleys on it, and tips between them this much farther out. */
function side(from: Point, to: Point, outward: Point): Point[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const teeth = Math.max(1, Math.round(Math.max(Math.abs(dx), Math.abs(dy)) / PITCH_MM));
  return Array.from({ length: 2 * teeth }, (_, half): Point => {
    const share = half / (2 * teeth);
    const isTip = half % 2 === 1;
    return [from[0] + share * dx + (isTip ? outward[0] : 0), from[1] + share * dy + (isTip ? outward[1] : 0)];
  });
}
