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

/**
 * Matches of a league in the order of its rounds, in each of which nobody plays twice: so nobody is far ahead in matches while the
 * table grows.
 */
export function inRounds<T extends Pairing>(matches: readonly T[], count: number): readonly T[] {
  const rounds = count % 2 === 0 ? count - 1 : count;
  const roundOf = ({ a, b }: Pairing): number => {
    if (b === null) return 0;
    const [one, other] = [Math.min(a, b), Math.max(a, b)];
    return (one + (other === rounds ? one : other)) % rounds;
  };
  return matches.toSorted((one, other) => one.seed - other.seed || roundOf(one) - roundOf(other));
}
