import { exactAsin } from '#core/exact-math';

const PI = 3.141592653589793;

/**
 * How much of a disc of radius 1 lies left of a vertical line at x: 0 at −1, ½ at 0, 1 at 1.
 */
export function discShareLeftOf(x: number): number {
  if (x <= -1) return 0;
  if (x >= 1) return 1;
  return 0.5 + (x * Math.sqrt(1 - x * x) + exactAsin(x)) / PI;
}

/**
 * How much of a disc a straight band covers, 0 … 1.
 *
 * @param distance from the disc's middle to the band's middle line
 * @param halfWidth of the band
 * @param radius of the disc, above 0; all three in the same unit
 */
export function bandCoverage(distance: number, halfWidth: number, radius: number): number {
  return discShareLeftOf((distance + halfWidth) / radius) - discShareLeftOf((distance - halfWidth) / radius);
}
