/** Degrees to radians. */
export const radOf = (deg: number): number => (deg * Math.PI) / 180;

/**
 * Degrees of an object of a course to radians. Multiples of 45° give the very bits that eighths of a turn gave before
 * there were degrees: recorded runs depend on them.
 */
export const rotationRad = (angleDeg: number): number => ((angleDeg / 45) * Math.PI) / 4;

/** Radians to degrees. */
export const degOf = (rad: number): number => (rad * 180) / Math.PI;

/** The same direction in degrees, more than −180 up to 180; never a negative zero. */
export function wrappedDeg(deg: number): number {
  const rest = deg % 360;
  return (rest > 180 ? rest - 360 : rest <= -180 ? rest + 360 : rest) + 0;
}

/** The same direction in degrees from 0 up to but without 360; never a negative zero. */
export function fullTurnDeg(deg: number): number {
  const rest = deg % 360;
  const turned = rest < 0 ? rest + 360 : rest;
  return turned === 360 ? 0 : turned + 0; // so little below 0 that it is rounded away
}
