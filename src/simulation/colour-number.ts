import { floorRgb, paintRgb } from '#scene/paint/reflectance';
import { paintColors, type PaintColor } from '#scene/paint/paint';
import type { Shares } from '#world/shapes';

/** Colours without a hue, which a camera does not learn. */
const HUELESS: readonly PaintColor[] = ['black', 'gray', 'white', 'silver'];

/** The colours that a camera knows, in the order of the palette: their places are their numbers, from 1. */
export const numberedColours = paintColors.filter((color) => !HUELESS.includes(color));

/** The number under which a camera knows a colour, from its shares compared with bare floor; 0: it is none. */
export function colourNumber(shares: Shares): number {
  if (Math.min(...shares) > 0.9) return 0; // mostly: bare floor
  let best: PaintColor = 'white';
  let least = Infinity;
  for (const color of paintColors) {
    const off = paintRgb[color].reduce((sum, share, i) => {
      const by = share - (shares[i] ?? 0) * (floorRgb[i] ?? 0);
      return sum + by * by;
    }, 0);
    if (off < least) [least, best] = [off, color];
  }
  return numberedColours.indexOf(best) + 1;
}
