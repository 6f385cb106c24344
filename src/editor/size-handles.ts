import type { Bounds } from '#scene/outline';
import type { Point } from '#scene/scene';
import type { Handle } from './tools/tool';

/**
 * The size handles of a rectangle: −1, 0 or 1 along its x and y. Eight where there is
 * room; on what is small under the pointer fewer, so that they neither cover it nor each other.
 *
 * @param reachMm how near counts as on a handle
 */
export function sizeSides([width, height]: Point, reachMm: number): readonly Point[] {
  const columns = endsAlong(width, reachMm);
  const rows = endsAlong(height, reachMm);
  return columns.flatMap((x) => rows.flatMap((y): readonly Point[] => (x === 0 && y === 0 ? [] : [[x, y]])));
}

/** The handles at corners and sides of an upright rectangle. */
export const boundsHandles = (around: Bounds, id: string | null, reachMm: number): readonly Handle[] => {
  const { minX, minY, maxX, maxY } = around;
  const half = { x: (maxX - minX) / 2, y: (maxY - minY) / 2 };
  return sizeSides([2 * half.x, 2 * half.y], reachMm).map((side) => ({
    ...{ kind: 'size', id, side },
    at: { x: minX + half.x * (1 + side[0]), y: minY + half.y * (1 + side[1]) },
  }));
};

/** The handles along one axis. Chosen: neighbours do not overlap, and between two a finger finds the thing itself. */
function endsAlong(lengthMm: number, reachMm: number): readonly number[] {
  if (lengthMm >= 6 * reachMm) return [-1, 0, 1];
  return lengthMm >= 3 * reachMm ? [-1, 1] : [1];
}
