import { GRAVITY_MG } from '#board/sensors/sensors';
import { degOf } from '#core/angle';

/** Acceleration in mg: x to the right edge, y to the edge with the pins, z out of the display. */
export interface Acceleration {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** The acceleration of a board lying flat, display up: gravity into its back. */
export const LEVEL: Acceleration = { x: 0, y: 0, z: -GRAVITY_MG };

/**
 * The acceleration of a board tilted by a drag: `right` and `down` are shares of a quarter turn's
 * sine, −1 … 1; beyond the rim of the circle the board stands upright.
 */
export function accelerationOf(right: number, down: number): Acceleration {
  const far = Math.hypot(right, down);
  const scale = far > 1 ? 1 / far : 1;
  const [x, y] = [right * scale, down * scale];
  const whole = (share: number): number => Math.round(share * GRAVITY_MG) + 0; // no −0
  return { x: whole(x), y: whole(y), z: whole(-Math.sqrt(Math.max(0, 1 - x * x - y * y))) };
}

/**
 * The angles at which a board with this acceleration is drawn, in degrees: its right and its lower edge turn away from
 * the eye.
 */
export function anglesOf({ x, y }: Pick<Acceleration, 'x' | 'y'>): {
  readonly rightDeg: number;
  readonly downDeg: number;
} {
  const degrees = (mg: number): number => degOf(Math.asin(Math.max(-1, Math.min(1, mg / GRAVITY_MG))));
  return { rightDeg: degrees(x), downDeg: degrees(y) };
}
