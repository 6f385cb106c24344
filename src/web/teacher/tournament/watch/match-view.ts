import { boundsOf } from '#scene/kinds/index';
import type { Bounds } from '#scene/outline';
import type { Scene } from '#scene/scene';

/** Room around a ring in which a robot that leaves it is seen, in mm. Chosen: it is whole in it when the match is decided. */
const BESIDE_MM = 150;

/** The part of a course that is shown of a match, in world mm: the whole arena, or a ring and what lies beside it. */
export function matchView({ task, size: [width, height], objects }: Scene): Bounds {
  const ring = task.robots === 'ring' ? objects.find(({ type }) => type === 'target') : undefined;
  if (ring === undefined) return { minX: 0, minY: 0, maxX: width, maxY: height };
  const { minX, minY, maxX, maxY } = boundsOf(ring);
  return {
    ...{ minX: Math.max(0, minX - BESIDE_MM), minY: Math.max(0, minY - BESIDE_MM) },
    ...{ maxX: Math.min(width, maxX + BESIDE_MM), maxY: Math.min(height, maxY + BESIDE_MM) },
  };
}
