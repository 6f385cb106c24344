import type { ColourState } from '#robots/robot';
import type { Watcher } from './news';

/** A colour is told once it has been seen for so long, in ms. Chosen: on the border of two papers a third one shows for a moment. */
const SURE_AFTER_MS = 300;

/** Finds out when a colour sensor comes onto another colour. Its first one is no news. */
export function watchColour(): Watcher {
  const sides = new Map<ColourState['side'], { told: string; now: string; sinceMs: number }>();
  return (seen) =>
    seen.colours.flatMap(({ side, name }) => {
      const known = sides.get(side);
      if (known === undefined) {
        sides.set(side, { told: name, now: name, sinceMs: seen.atMs });
        return [];
      }
      if (known.now !== name) [known.now, known.sinceMs] = [name, seen.atMs];
      if (known.told === name || seen.atMs - known.sinceMs < SURE_AFTER_MS) return [];
      known.told = name;
      return [{ topic: 'colour' as const, side, name, seen }];
    });
}
