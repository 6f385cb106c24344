import type { Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import type { FieldShape } from '../shapes';
import type { FloorPicture } from './floor-grid';

/** A painted field on the floor, under all strokes. */
export interface Field {
  readonly reflectance: number;
  /** Fields on higher layers cover those below. */
  layer: number;
  /** How deep at least a place lies in it, in mm; below 0: how far at least it is away. Never changes faster than the place. */
  depth(x: number, y: number): number;
}

/** Rows of a spot that lies on an edge, and the looks in each. Chosen: mixes to a hundredth, and edges are rare. */
const ROWS = 24;
const LOOKS = 24;

/** Distance of each row from the middle and its weight, for a disc of radius 1: Gauss's rule (Chebyshev, second kind). */
const rows = Array.from({ length: ROWS }, (_, i) => {
  const angle = (Math.PI * (i + 1)) / (ROWS + 1);
  const sin = exactSin(angle);
  return { offset: exactCos(angle), half: sin, weight: (2 * sin * sin) / (ROWS + 1) };
});

/** The places of the looks in a row that reaches from −1 to 1. */
const looks = Array.from({ length: LOOKS }, (_, look) => (2 * look + 1) / LOOKS - 1);

/** A middle and an end are as far apart as they seem, up to rounding. */
const ROUNDING_MM = 1e-6;

/** A row of looks in a spot: its middle, half of its length in radii, and the radius. */
interface Row {
  readonly x: number;
  readonly y: number;
  readonly half: number;
  readonly radius: number;
}

/** Makes a field of a shape. */
export function fieldOf(shape: FieldShape, reflectance: number, layer: number): Field {
  const { x: middleX, y: middleY } = shape.atMm;
  const [cos, sin] = shape.angleRad === 0 ? [1, 0] : [exactCos(shape.angleRad), exactSin(shape.angleRad)];
  const own = depthOf(shape);
  return {
    reflectance,
    layer,
    depth: (x, y) => own((x - middleX) * cos + (y - middleY) * sin, (y - middleY) * cos - (x - middleX) * sin),
  };
}

/** The depth of a place that is given in the frame of the shape. */
function depthOf({ sizeMm, isRound, partsMm }: FieldShape): Field['depth'] {
  const [halfX, halfY] = [sizeMm.x / 2, sizeMm.y / 2];
  if (isRound === true) {
    const least = Math.min(halfX, halfY);
    return (x, y) => {
      const alongX = x / halfX;
      const alongY = y / halfY;
      return (1 - Math.sqrt(alongX * alongX + alongY * alongY)) * least;
    };
  }
  if (partsMm === undefined) return (x, y) => Math.min(halfX - Math.abs(x), halfY - Math.abs(y));
  return (x, y) => partsMm.reduce((deepest, part) => Math.max(deepest, depthInPart(part, x, y)), -Infinity);
}

function depthInPart(corners: readonly Vec[], x: number, y: number): number {
  let depth = Infinity;
  let from = corners[corners.length - 1];
  for (const to of corners) {
    if (from === undefined) return -Infinity;
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    // Counter-clockwise: what lies inside is on the left of each edge.
    depth = Math.min(depth, (dx * (y - from.y) - dy * (x - from.x)) / Math.sqrt(dx * dx + dy * dy));
    from = to;
  }
  return depth;
}

/**
 * The ground under a spot where fields are: an even reflectance, or a mixture of what they cover and leave.
 *
 * @param fields from the highest layer to the lowest
 * @param below the picture or, as 1, the bare floor under them
 */
export function underFields(
  fields: readonly Field[],
  below: 1 | FloorPicture,
  x: number,
  y: number,
  radius: number,
): number | FloorPicture {
  const near: Field[] = [];
  for (const field of fields) {
    const depth = field.depth(x, y);
    if (depth <= -radius) continue;
    if (depth >= radius && near.length === 0) return field.reflectance;
    near.push(field);
    if (depth >= radius) break; // nothing shows from below it
  }
  return near.length === 0 ? below : new Mixture(near, below);
}

/** A floor of fields, and of what they leave of the one below them. */
class Mixture implements FloorPicture {
  constructor(
    private readonly fields: readonly Field[],
    private readonly below: 1 | FloorPicture,
  ) {}

  at(x: number, y: number): number {
    const { fields, below } = this;
    for (const field of fields) if (field.depth(x, y) >= 0) return field.reflectance;
    return below === 1 ? 1 : below.at(x, y);
  }

  under(x: number, y: number, radius: number): number {
    let mean = 0;
    for (const { offset, half, weight } of rows) {
      const sum = this.withLooks(0, { x, y: y + offset * radius, half, radius }, 0, LOOKS, 0);
      mean += (weight * sum) / LOOKS;
    }
    return mean;
  }

  /**
   * A sum with some looks of a row added, from left to right. What a field holds as a whole, or does not reach, needs one look
   * at its middle.
   *
   * @param place of the first field that may show
   */
  private withLooks(place: number, row: Row, from: number, to: number, sum: number): number {
    const field = this.fields[place];
    if (to - from === 1) return sum + this.at(row.x + (looks[from] ?? 0) * row.half * row.radius, row.y);
    const [left = 0, right = 0] = [looks[from], looks[to - 1]];
    const reach = ((right - left) / 2) * row.half * row.radius + ROUNDING_MM;
    const depth = field ? field.depth(row.x + ((left + right) / 2) * row.half * row.radius, row.y) : Infinity;
    if (depth <= -reach) return this.withLooks(place + 1, row, from, to, sum);
    if (depth >= reach && (field || this.below === 1)) {
      const all = field ? field.reflectance : 1;
      for (let look = from; look < to; look++) sum += all;
      return sum;
    }
    const middle = (from + to) >> 1;
    return this.withLooks(place, row, middle, to, this.withLooks(place, row, from, middle, sum));
  }
}
