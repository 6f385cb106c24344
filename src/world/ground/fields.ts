import type { Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import type { FieldShape } from '../shapes';
import type { FloorPicture } from './floor-grid';

/** A painted field on the floor, under all strokes. */
export interface Field {
  readonly reflectance: number;
  /** Fields on higher layers cover those below. */
  layer: number;
  holds(x: number, y: number): boolean;
  /** How much of a round spot it covers; `part` also where it is not sure. */
  covers(x: number, y: number, radius: number): 'all' | 'none' | 'part';
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

/** Makes a field of a shape. */
export function fieldOf(shape: FieldShape, reflectance: number, layer: number): Field {
  const { atMm, angleRad } = shape;
  const [cos, sin] = angleRad === 0 ? [1, 0] : [exactCos(angleRad), exactSin(angleRad)];
  const own = (x: number, y: number): Vec => ({
    x: (x - atMm.x) * cos + (y - atMm.y) * sin,
    y: (y - atMm.y) * cos - (x - atMm.x) * sin,
  });
  const depth = depthOf(shape);
  return {
    reflectance,
    layer,
    holds: (x, y) => depth(own(x, y)) >= 0,
    covers(x, y, radius) {
      const mm = depth(own(x, y));
      return mm >= radius ? 'all' : mm <= -radius ? 'none' : 'part';
    },
  };
}

/** How deep at least a place lies in a shape, in mm; below 0: how far at least it is away. */
function depthOf({ sizeMm, isRound, partsMm }: FieldShape): (place: Vec) => number {
  const [halfX, halfY] = [sizeMm.x / 2, sizeMm.y / 2];
  if (isRound === true) {
    const least = Math.min(halfX, halfY);
    return ({ x, y }) => {
      const [alongX, alongY] = [x / halfX, y / halfY];
      return (1 - Math.sqrt(alongX * alongX + alongY * alongY)) * least;
    };
  }
  if (partsMm === undefined) return ({ x, y }) => Math.min(halfX - Math.abs(x), halfY - Math.abs(y));
  return (place) => partsMm.reduce((deepest, part) => Math.max(deepest, depthInPart(part, place)), -Infinity);
}

function depthInPart(corners: readonly Vec[], { x, y }: Vec): number {
  let depth = Infinity;
  let from = corners[corners.length - 1];
  for (const to of corners) {
    if (from === undefined) return -Infinity;
    const [dx, dy] = [to.x - from.x, to.y - from.y];
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
    const covered = field.covers(x, y, radius);
    if (covered === 'none') continue;
    if (covered === 'all' && near.length === 0) return field.reflectance;
    near.push(field);
    if (covered === 'all') break; // nothing shows from below it
  }
  return near.length === 0 ? below : mixture(near, below);
}

function mixture(fields: readonly Field[], below: 1 | FloorPicture): FloorPicture {
  const at = (x: number, y: number): number => {
    const field = fields.find((each) => each.holds(x, y));
    return field?.reflectance ?? (below === 1 ? 1 : below.at(x, y));
  };
  return {
    at,
    under(x, y, radius) {
      let mean = 0;
      for (const { offset, half, weight } of rows) {
        let sum = 0;
        for (let look = 0; look < LOOKS; look++)
          sum += at(x + ((2 * look + 1) / LOOKS - 1) * half * radius, y + offset * radius);
        mean += (weight * sum) / LOOKS;
      }
      return mean;
    },
  };
}
