import type { Pose, Vec } from '#core/geometry';
import { stopsOf } from '#scene/kinds/mover-way';
import type { Mover } from '#scene/scene';
import { placedAtStart } from '../picture/draw-bodies';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type View } from '../view/view-transform';
import { spriteSquare } from './sprite-square';

/** Place of a picture: its middle in px, and its rotation from its start, counter-clockwise. */
export interface SpritePlace extends Vec {
  readonly turnedRad: number;
}

/** Place of the picture of an obstacle at a pose; without one, at its start. */
export function spritePlace(view: View, mover: Mover, pose: Pose | null): SpritePlace {
  const start = placedAtStart(mover).pose;
  const { xMm, yMm, headingRad } = pose ?? start;
  return { ...toPx(view, { x: xMm, y: yMm }), turnedRad: headingRad - start.headingRad };
}

/**
 * The part of the canvas that a moving obstacle passes, from a whole pixel on, as far as it is in sight. A canvas there
 * never moves: moving one makes the browser sort all layers of the page for each picture.
 *
 * @param ratio canvas pixels per CSS px
 */
export function wayWindow(mover: Mover, view: View, sight: PxBox, ratio: number): PxBox {
  const half = spriteSquare(mover, view.pxPerMm).sidePx / 2;
  const ends = stopsOf(mover).map(({ at: [x, y] }) => boxAround(toPx(view, { x, y }), half));
  const { left, top, width, height } = unionOf(ends);
  const whole = (px: number): number => Math.floor(px * ratio) / ratio;
  const from = { x: whole(Math.max(sight.left, left)), y: whole(Math.max(sight.top, top)) };
  const right = Math.min(sight.left + sight.width, left + width);
  const bottom = Math.min(sight.top + sight.height, top + height);
  return { left: from.x, top: from.y, width: Math.max(0, right - from.x), height: Math.max(0, bottom - from.y) };
}
