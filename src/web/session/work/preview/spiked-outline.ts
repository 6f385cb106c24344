import type { Vec } from '#core/geometry';
import type { Point, Shaped } from '#scene/scene';
import { ownOutline } from '#scene/shape/shape';

/** Approximate distance of teeth along a side, in mm. Chosen: still teeth, and not dust, on a small picture. */
const PITCH_MM = 34;

type Spiky = Pick<Shaped, 'size' | 'round' | 'corners'>;

/** The outline of a shape with teeth around it, about its centre, as the `points` of an SVG polygon: tips lie on the edge. */
export function spikedOutline(shape: Spiky): string {
  if (shape.corners || shape.round === true) return spikedAround(shape);
  const [width, height] = shape.size;
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

/** Teeth around an ellipse or a polygon: tips on its edge, valleys on the same shape made smaller. */
function spikedAround(shape: Spiky): string {
  const [width, height] = shape.size;
  const depth = Math.min(14, Math.min(width, height) * 0.3);
  const valleys: Point = [1 - (2 * depth) / width, 1 - (2 * depth) / height];
  const outline = ownOutline(shape);
  const tips = shape.corners ? outline.flatMap((from, index) => along(from, outline[(index + 1) % outline.length] ?? from)) : outline.filter((_, index) => index % 2 === 0); // prettier-ignore
  return tips
    .flatMap(({ x, y }, index): Point[] => {
      const next = tips[(index + 1) % tips.length] ?? { x, y };
      return [[x, y], [((x + next.x) / 2) * valleys[0], ((y + next.y) / 2) * valleys[1]]]; // prettier-ignore
    })
    .map((point) => point.map(Math.round).join(','))
    .join(' ');
}

/** Places along an edge, without its end. */
function along(from: Vec, to: Vec): Vec[] {
  const count = Math.max(1, Math.round(Math.hypot(to.x - from.x, to.y - from.y) / PITCH_MM));
  return Array.from({ length: count }, (_, i) => ({
    x: from.x + ((to.x - from.x) * i) / count,
    y: from.y + ((to.y - from.y) * i) / count,
  }));
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
