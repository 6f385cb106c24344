import { exactCos, exactSin } from '#core/exact-math';
import type { Pose } from '#core/geometry';
import { movedOutline, type Outline } from '#scene/outline';

/** An outline in a body's own frame, in world mm where the body is. */
export function outlineAt(outline: Outline, { xMm: x, yMm: y, headingRad }: Pose): Outline {
  return movedOutline(outline, { x, y }, { x: exactCos(headingRad), y: exactSin(headingRad) });
}
