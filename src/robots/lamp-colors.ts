import type { Rgb } from '#core/rgb';

/** Colours by the numbers that the controllers of several robots take: DFRobot maqueenplus.ts, `Color`. */
export const lampColors: readonly Rgb[] = [
  [0, 0, 0],
  [255, 0, 0],
  [0, 255, 0],
  [255, 255, 0],
  [0, 0, 255],
  [255, 0, 255],
  [0, 255, 255],
  [255, 255, 255],
];

/** The colour with this number: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, all others off. */
export const lampColor = (number: number): Rgb => lampColors[number] ?? [0, 0, 0];

/** The number of a colour, or `null` if it has none. */
export function lampNumber([r, g, b]: Rgb): number | null {
  const number = lampColors.findIndex((color) => color[0] === r && color[1] === g && color[2] === b);
  return number < 0 ? null : number;
}
