import type { Vec } from '#core/geometry';
import { lengthOf, type Outline } from '#scene/outline';
import type { SceneObject } from '#scene/scene';
import { outlineHolds } from '#scene/shape/shape';

/** The black lines of a course: whether a robot stands over one. */
export interface LinePlaces {
  /** True if any part of these convex outlines, all within `reachMm` of `at`, lies over the middle of a black line. */
  isUnder(parts: readonly Outline[], at: Vec, reachMm: number): boolean;
}

/** Distance of the places that stand for a line. Chosen: a robot is several times as long. */
const STEP_MM = 10;

/** Chosen: 2 km of line; what is longer is none that a robot follows. */
const MOST_PLACES = 200_000;

/** Side of the squares in which the places are sorted. */
const SQUARE_MM = 100;

const keyOf = (x: number, y: number): string => `${String(x)},${String(y)}`;
const squareOf = (mm: number): number => Math.floor(mm / SQUARE_MM);

/** Makes them. */
export function linePlaces(objects: readonly SceneObject[]): LinePlaces {
  const squares = new Map<string, Vec[]>();
  let count = 0;
  for (const place of placesOf(objects)) {
    if (++count > MOST_PLACES) break;
    const key = keyOf(squareOf(place.x), squareOf(place.y));
    const inside = squares.get(key);
    if (inside === undefined) squares.set(key, [place]);
    else inside.push(place);
  }
  return {
    isUnder(parts, { x: atX, y: atY }, reachMm) {
      for (let x = squareOf(atX - reachMm); x <= squareOf(atX + reachMm); x++)
        for (let y = squareOf(atY - reachMm); y <= squareOf(atY + reachMm); y++)
          for (const place of squares.get(keyOf(x, y)) ?? [])
            if (parts.some((part) => outlineHolds(part, place, 0))) return true;
      return false;
    },
  };
}

function* placesOf(objects: readonly SceneObject[]): Generator<Vec> {
  for (const object of objects) {
    if (object.type !== 'stroke' || object.color !== 'black') continue;
    for (const [index, [x, y]] of object.points.entries()) {
      const [toX, toY] = object.points[index + 1] ?? [x, y];
      const pieces = Math.max(1, Math.ceil(lengthOf(toX - x, toY - y) / STEP_MM));
      for (let piece = 0; piece < pieces; piece++)
        yield { x: x + ((toX - x) * piece) / pieces, y: y + ((toY - y) * piece) / pieces };
      yield { x: toX, y: toY };
    }
  }
}
