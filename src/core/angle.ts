/** Degrees to radians. */
export const radOf = (deg: number): number => (deg * Math.PI) / 180;

/** Radians to degrees. */
export const degOf = (rad: number): number => (rad * 180) / Math.PI;

/** The same direction in degrees, more than −180 up to 180; never a negative zero. */
export function wrappedDeg(deg: number): number {
  const rest = deg % 360;
  return (rest > 180 ? rest - 360 : rest <= -180 ? rest + 360 : rest) + 0;
}
