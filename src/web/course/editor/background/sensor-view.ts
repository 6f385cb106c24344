import { BRIGHTEST_LEVEL } from '#scene/background';

import { evened, type Cells } from './even-light';
import { FULL_BRIGHTNESS } from './raster';

/** How the line sensors shall see a picture. */
export interface SensorView {
  /** `line`: bare floor or line, nothing between; `greys`: all sixteen levels as the picture has them. */
  readonly steps: 'line' | 'greys';
  /** Anything darker than this share of bare floor is line, in percent. */
  readonly thresholdPercent: number;
  /** Shadows and a lamp at one side are taken out. */
  readonly isEven: boolean;
}

/** The cells as they are judged: with shadows taken out (`isEven`), or as they are. */
export const evenedIf = (cells: Cells, isEven: boolean): Cells => (isEven ? evened(cells) : cells);

/**
 * The levels that the line sensors will see.
 *
 * @param cells in the light in which they are judged
 */
export function levelsOf({ brightness }: Cells, { steps, thresholdPercent }: SensorView): Uint8Array {
  const threshold = (FULL_BRIGHTNESS * thresholdPercent) / 100;
  return steps === 'line'
    ? Uint8Array.from(brightness, (value) => (value < threshold ? 0 : BRIGHTEST_LEVEL))
    : Uint8Array.from(brightness, (value) => Math.floor(value / (FULL_BRIGHTNESS / BRIGHTEST_LEVEL) + 0.5));
}

/** Steps of the search for a threshold. */
const BINS = 100;

/**
 * The threshold that parts dark from bright best, in percent: the one with the most variance between the two (Otsu, _A
 * Threshold Selection Method from Gray-Level Histograms_, 1979). Half if there is nothing to part.
 */
export function goodThreshold({ brightness }: Cells): number {
  const counts = new Float64Array(BINS);
  for (const value of brightness) {
    const bin = Math.min(BINS - 1, Math.floor((value * BINS) / FULL_BRIGHTNESS));
    counts[bin] = (counts[bin] ?? 0) + 1;
  }
  const total = brightness.length;
  const sum = counts.reduce((all, count, bin) => all + count * bin, 0);
  let [below, sumBelow, best, first, last] = [0, 0, 0, BINS / 2, BINS / 2];
  for (let bin = 0; bin < BINS - 1; bin += 1) {
    below += counts[bin] ?? 0;
    sumBelow += (counts[bin] ?? 0) * bin;
    if (below === 0 || below === total) continue;
    const apart = sumBelow / below - (sum - sumBelow) / (total - below);
    const variance = below * (total - below) * apart * apart;
    if (variance > best) [best, first, last] = [variance, bin + 1, bin + 1];
    else if (variance === best) last = bin + 1; // nothing lies between: in the middle of the gap
  }
  return Math.round((first + last) / 2);
}
