import type { Vec } from '#core/geometry';
import type { Shares } from '../shapes';
import { nearestInCone, type Cone, type Obstacle } from './distance-cone';

/** The nearest thing in a beam. */
export interface ColorHit {
  readonly distanceMm: number;
  /** Shares of light that it returns, each 1 for white as of bare floor. */
  readonly shares: Shares;
}

/** Things without a colour: a grey as of cardboard and plastic. Chosen. */
const PLAIN: Shares = [0.47, 0.47, 0.47];

/** The nearest thing in a cone and its colour; `null`: nothing is in range. */
export function nearestColor(
  from: Vec,
  headingRad: number,
  cone: Cone,
  obstacles: Iterable<Obstacle>,
): ColorHit | null {
  const all = [...obstacles];
  if (nearestInCone(from, headingRad, cone, all).distanceMm === Infinity) return null; // mostly
  let best: ColorHit | null = null;
  for (const obstacle of all) {
    const { distanceMm } = nearestInCone(from, headingRad, cone, [obstacle]);
    if (distanceMm < (best?.distanceMm ?? Infinity)) best = { distanceMm, shares: obstacle.shares ?? PLAIN };
  }
  return best;
}
