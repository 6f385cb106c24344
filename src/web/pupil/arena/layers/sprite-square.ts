import type { Mover } from '#scene/scene';
import type { View } from '../view/view-transform';

/** The square canvas for the picture of an obstacle or a block in any rotation. */
export interface SpriteSquare {
  /** Side of the square canvas, in CSS px. */
  readonly sidePx: number;
  /** The view in which the obstacle at its start lies in the middle of the canvas. */
  readonly view: View;
}

/** Room for the shadow, in px. */
const RIM_PX = 8;

/** The canvas for an obstacle or a block, at this many px per mm. */
export function spriteSquare({ at, size }: Pick<Mover, 'at' | 'size'>, pxPerMm: number): SpriteSquare {
  const half = Math.ceil((Math.hypot(size[0], size[1]) / 2) * pxPerMm + RIM_PX);
  return {
    sidePx: 2 * half,
    view: { pxPerMm, leftPx: half - at[0] * pxPerMm, bottomPx: half + at[1] * pxPerMm },
  };
}
