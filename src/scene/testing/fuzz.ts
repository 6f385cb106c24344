import { createRng, type Rng } from '#core/rng';

/**
 * Checks a property for many seeds; a failure names its seed, so that it can be tried alone.
 *
 * @param run throws if the property does not hold
 */
export function forManySeeds(runs: number, run: (rng: Rng, seed: number) => void): void {
  const first = Number(process.env.FUZZ_SEED ?? 0);
  for (let seed = first; seed < first + runs; seed++) {
    try {
      run(createRng(seed), seed);
    } catch (error) {
      throw new Error(`With FUZZ_SEED=${seed}: ${String(error)}`, { cause: error });
    }
  }
}

/** A whole number from `min` to `max`. */
export const wholeFrom = (rng: Rng, min: number, max: number): number => min + (rng.u32() % (max - min + 1));

/** One of several things, of which there is at least one. */
export function oneOf<T>(rng: Rng, things: readonly T[]): T {
  const thing = things[rng.u32() % things.length];
  if (thing === undefined && things.length === 0) throw new RangeError('There is nothing to choose from.');
  return thing as T;
}

/** True in this many of a hundred cases. */
export const inPercent = (rng: Rng, percent: number): boolean => rng.u32() % 100 < percent;
