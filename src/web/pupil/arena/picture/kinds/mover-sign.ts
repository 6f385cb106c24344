import { mdiRotateRight } from '@mdi/js';
import { wayOf } from '#scene/kinds/mover-way';
import type { Mover, Point } from '#scene/scene';
import { moverSigns } from '../../../../course/editor/parts/mover-signs';

/** The icon of what a mover does. */
export function moverSign(mover: Mover): string {
  const way = wayOf(mover);
  return way === 'stays' && (mover.spin ?? 0) < 0 ? mdiRotateRight : moverSigns[way];
}

/** How far its icon is turned from upright, counter-clockwise: arrows lie along the first leg. */
export function moverSignRad(mover: Mover): number {
  if (wayOf(mover) !== 'to-and-fro') return 0;
  const { at, to } = mover;
  return Math.atan2(to[1] - at[1], to[0] - at[0]);
}

/** The places along which a mover's way is drawn, without its end: closed when it goes round. */
export const closedWay = (mover: Mover, stops: readonly Point[]): readonly Point[] =>
  mover.loops && stops.length > 2 ? [...stops, ...stops.slice(0, 1)] : stops;
