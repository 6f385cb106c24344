import type { Bounds, Outline } from '#scene/outline';
import type { Point } from '#scene/scene';

/** A rectangle made larger on all sides. */
export const grown = ({ minX, minY, maxX, maxY }: Bounds, byMm: number): Bounds => ({
  minX: minX - byMm,
  minY: minY - byMm,
  maxX: maxX + byMm,
  maxY: maxY + byMm,
});

/** The rectangle around several; `null` for none. */
export function boundsAll(all: readonly Bounds[]): Bounds | null {
  const [first, ...rest] = all;
  return first === undefined
    ? null
    : rest.reduce(
        (one, other) => ({
          minX: Math.min(one.minX, other.minX),
          minY: Math.min(one.minY, other.minY),
          maxX: Math.max(one.maxX, other.maxX),
          maxY: Math.max(one.maxY, other.maxY),
        }),
        first,
      );
}

/** The four corners of an upright rectangle. */
export const cornersOf = ({ minX, minY, maxX, maxY }: Bounds): Outline => [
  { x: minX, y: minY },
  { x: maxX, y: minY },
  { x: maxX, y: maxY },
  { x: minX, y: maxY },
];

/** The arena as a rectangle. */
export const arenaBounds = ([width, height]: Point): Bounds => ({ minX: 0, minY: 0, maxX: width, maxY: height });

/** A rectangle that was moved. */
export const shiftedBounds = ({ minX, minY, maxX, maxY }: Bounds, [dx, dy]: Point): Bounds => ({
  minX: minX + dx,
  minY: minY + dy,
  maxX: maxX + dx,
  maxY: maxY + dy,
});
