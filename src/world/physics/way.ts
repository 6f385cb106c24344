import type { Vec } from '#core/geometry';
import type { Way } from '../shapes';
import { STEP_US } from '../step';

/** A leg of a way, or a wait. Waits have lengths, too: that of the leg that would take as long. */
interface Piece {
  /** Distance of its end, along all pieces. */
  readonly endMm: number;
  readonly from: Vec;
  readonly to: Vec;
  readonly lengthMm: number;
  /** True if it leads from `to` to `from`: a leg has the same places there and back to the last bit. */
  readonly isBack: boolean;
}

/** The place of a thing on its way after a number of steps of the world, in mm. */
export function placesAlong(way: Way, speedMmPerS: number): (steps: number) => Vec {
  const pieces = piecesOf(way, speedMmPerS);
  const home = way.stops[0]?.atMm ?? { x: 0, y: 0 };
  const roundMm = pieces[pieces.length - 1]?.endMm ?? 0;
  return (steps) => {
    if (roundMm === 0) return home;
    const travelledMm = ((steps * STEP_US * speedMmPerS) / 1_000_000 + way.phaseS * speedMmPerS) % roundMm;
    const at = pieces.findIndex(({ endMm }) => travelledMm <= endMm);
    const piece = pieces[at];
    return piece === undefined ? home : placeOn(piece, travelledMm, pieces[at - 1]?.endMm ?? 0);
  };
}

function placeOn({ endMm, from, to, lengthMm, isBack }: Piece, travelledMm: number, startMm: number): Vec {
  if (from === to) return from;
  const share = (isBack ? endMm - travelledMm : travelledMm - startMm) / lengthMm;
  return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
}

/** One round along a way: at each stop a wait, then the leg to the next one. */
function piecesOf({ stops, loops }: Way, speedMmPerS: number): readonly Piece[] {
  const order = loops ? stops : [...stops, ...stops.slice(1, -1).reverse()];
  const pieces: Piece[] = [];
  let endMm = 0;
  const add = (from: Vec, to: Vec, lengthMm: number, isBack: boolean): void => {
    if (lengthMm === 0) return;
    endMm += lengthMm;
    pieces.push({ endMm, from, to, lengthMm, isBack });
  };
  order.forEach(({ atMm, waitS }, index) => {
    const next = order[(index + 1) % order.length]?.atMm ?? atMm;
    const [dx, dy] = [next.x - atMm.x, next.y - atMm.y];
    const lengthMm = Math.sqrt(dx * dx + dy * dy);
    const isBack = !loops && index >= stops.length - 1;
    add(atMm, atMm, waitS * speedMmPerS, false);
    add(...(isBack ? ([next, atMm] as const) : ([atMm, next] as const)), lengthMm, isBack);
  });
  return pieces;
}
