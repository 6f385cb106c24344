import { exactAsin } from '#core/exact-math';

const PI = 3.141592653589793;

/** Share of a disc of radius 1 left of a vertical line at x: 0 at −1, ½ at 0, 1 at 1. */
export function discShareLeftOf(x: number): number {
  if (x <= -1) return 0;
  if (x >= 1) return 1;
  return 0.5 + (x * Math.sqrt(1 - x * x) + exactAsin(x)) / PI;
}

/**
 * Share of a disc that a straight band covers, 0 … 1.
 *
 * @param distance from the disc's middle to the band's middle line
 * @param halfWidth of the band
 * @param radius of the disc, above 0; all three in the same unit
 */
export function bandCoverage(distance: number, halfWidth: number, radius: number): number {
  return discShareLeftOf((distance + halfWidth) / radius) - discShareLeftOf((distance - halfWidth) / radius);
}

/** Share of a disc of radius 1 left of x and below y: a quarter for 0, 0. */
export function discShareLeftBelow(x: number, y: number): number {
  if (x <= -1 || y <= -1) return 0;
  if (x >= 1) return discShareLeftOf(y);
  if (y >= 1) return discShareLeftOf(x);
  if (x * x + y * y >= 1) {
    // The corner lies outside: the disc loses up to two caps that do not meet, or is cut by one line only.
    if (x > 0 && y > 0) return discShareLeftOf(x) + discShareLeftOf(y) - 1;
    if (x > 0) return discShareLeftOf(y);
    return y > 0 ? discShareLeftOf(x) : 0;
  }
  // From the left rim to x, the height between the lower rim and y.
  const quarter =
    (x * y + 0.5 * (x * Math.sqrt(1 - x * x) + exactAsin(x) + y * Math.sqrt(1 - y * y) + exactAsin(y))) / PI;
  return 0.25 + quarter;
}
