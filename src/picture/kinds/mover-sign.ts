import { mdiArrowLeftRightBold, mdiEye, mdiRotateLeft, mdiRotateRight, mdiRunFast, mdiSync } from '@mdi/js';
import { exactAtan2 } from '#core/exact-math';
import { wayOf, type MoverWay } from '#scene/kinds/mover-way';
import type { Mover, Point } from '#scene/scene';

/** The icon of each thing that a mover can do. */
export const moverSigns: Readonly<Record<MoverWay, string>> = {
  'to-and-fro': mdiArrowLeftRightBold,
  round: mdiSync,
  stays: mdiRotateLeft,
  chases: mdiRunFast,
  guards: mdiEye,
};

/** The icon of what a mover does. */
export function moverSign(mover: Mover): string {
  const way = wayOf(mover);
  return way === 'stays' && (mover.spin ?? 0) < 0 ? mdiRotateRight : moverSigns[way];
}

/** How far its icon is turned from upright, counter-clockwise: arrows lie along the first leg. */
export function moverSignRad(mover: Mover): number {
  if (wayOf(mover) !== 'to-and-fro') return 0;
  const { at, to } = mover;
  return exactAtan2(to[1] - at[1], to[0] - at[0]);
}

/** The places along which a mover's way is drawn: its stops, and the first one again if it goes round. */
export const closedWay = (mover: Mover, stops: readonly Point[]): readonly Point[] =>
  mover.loops && stops.length > 2 ? [...stops, ...stops.slice(0, 1)] : stops;
