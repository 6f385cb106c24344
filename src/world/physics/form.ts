import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { rectangleCorners, type BodyForm } from '../shapes';
import { isInside, type Polygon } from './convex';
import { CircleShape, PolygonShape } from './planck';
import { toUnits, UNITS_PER_MM } from './scale';

/** Corners of what stands for a circle or an ellipse where convex outlines are compared. Chosen: 0.1 mm off for a can. */
const ROUND_CORNERS = 48;

const unitCircle: Polygon = Array.from({ length: ROUND_CORNERS }, (_, index) => {
  const rad = (index * 2 * Math.PI) / ROUND_CORNERS;
  return { x: exactCos(rad), y: exactSin(rad) };
});

/** The convex parts of a form about its middle, counter-clockwise, mm. */
export function formParts({ sizeMm: { x, y }, isRound, partsMm }: BodyForm): readonly Polygon[] {
  if (partsMm) return partsMm;
  if (isRound === true) return [unitCircle.map((corner) => ({ x: (corner.x * x) / 2, y: (corner.y * y) / 2 }))];
  return [rectangleCorners({ x, y })];
}

/** The radius of a form that is a circle, in mm; `null`: it is none. */
export const circleRadiusMm = ({ sizeMm: { x, y }, isRound }: BodyForm): number | null =>
  isRound === true && x === y ? x / 2 : null;

/** The shapes of a form for the engine, one for each of its parts. */
export function engineShapes(form: BodyForm, parts: readonly Polygon[]): readonly (CircleShape | PolygonShape)[] {
  const radiusMm = circleRadiusMm(form);
  if (radiusMm !== null) return [new CircleShape(radiusMm * UNITS_PER_MM)];
  return parts.map((part) => new PolygonShape(part.map(toUnits)));
}

/** A circle of the engine as a convex outline about its body's middle, in the engine's units. */
export const circleOutline = (radius: number): Polygon =>
  unitCircle.map(({ x, y }) => ({ x: x * radius, y: y * radius }));

/** The centroid of convex parts, in their frame and unit. */
export function centroidOf(parts: readonly Polygon[]): Vec {
  let [sum, x, y] = [0, 0, 0];
  for (const part of parts) {
    let from = part[part.length - 1] ?? { x: 0, y: 0 };
    for (const to of part) {
      const double = from.x * to.y - from.y * to.x;
      sum += 3 * double;
      x += double * (from.x + to.x);
      y += double * (from.y + to.y);
      from = to;
    }
  }
  return { x: x / sum, y: y / sum };
}

/** Mean distance of a form's area from its middle, in mm, from a grid of 16 × 16 points. @param parts about that middle */
export function meanRadiusMm({ sizeMm, isRound, partsMm }: BodyForm, parts: readonly Polygon[]): number {
  const isWhole = isRound !== true && partsMm === undefined;
  const corners = parts.flat();
  const [left, bottom] = [Math.min(...corners.map(({ x }) => x)), Math.min(...corners.map(({ y }) => y))];
  let [sum, count] = [0, 0];
  for (let i = 0; i < 16; i++) {
    for (let j = 0; j < 16; j++) {
      const x = isWhole ? ((i + 0.5) / 16 - 0.5) * sizeMm.x : left + ((i + 0.5) / 16) * sizeMm.x;
      const y = isWhole ? ((j + 0.5) / 16 - 0.5) * sizeMm.y : bottom + ((j + 0.5) / 16) * sizeMm.y;
      if (!isWhole && !parts.some((part) => isInside(part, { x, y }))) continue;
      sum += Math.sqrt(x * x + y * y);
      count++;
    }
  }
  return count === 0 ? Math.max(sizeMm.x, sizeMm.y) / 4 : sum / count;
}
