/** The limits of a type size, in px. */
export interface SizeLimits {
  readonly least: number;
  readonly most: number;
}

/** Shares of the window's shorter side: what the last row reads at 8 m, and at 5 m. Chosen, with a picture 1.2 m high. */
const MOST_SHARE = 0.05;
const LEAST_SHARE = 0.032;
/** On a phone, which is held in the hand. */
const HAND: SizeLimits = { least: 16, most: 20 };

export function sizeLimits(width: number, height: number): SizeLimits {
  const side = Math.min(width, height);
  return {
    least: Math.max(HAND.least, Math.floor(LEAST_SHARE * side)),
    most: Math.max(HAND.most, Math.floor(MOST_SHARE * side)),
  };
}

/** The largest whole size that fits; the least where none does: then the text scrolls. */
export function fittingSize({ least, most }: SizeLimits, fits: (px: number) => boolean): number {
  let [low, high] = [least, most];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (fits(middle)) low = middle;
    else high = middle - 1;
  }
  return low;
}
