import type { Pairing } from './match';

/**
 * The matches of everyone against everyone: each pair twice per seed, once on each side. In a course for one robot each
 * program runs once per seed.
 */
export function* leaguePairings(count: number, seeds: readonly number[], isAlone: boolean): Generator<Pairing> {
  for (let one = 0; one < count; one++) {
    if (isAlone) yield* seeds.map((seed) => ({ a: one, b: null, seed }));
    else for (let other = one + 1; other < count; other++) yield* meeting(one, other, seeds);
  }
}

/** The matches of a pair: per seed once on each side. */
export const meeting = (one: number, other: number, seeds: readonly number[]): readonly Pairing[] =>
  seeds.flatMap((seed) => [
    { a: one, b: other, seed },
    { a: other, b: one, seed },
  ]);
