import type { Match } from './match';
import { scoreOf } from './table';

/** A pair of a round, the first in order first; `null` as the second: the first goes on without a match. */
export type Tie = readonly [number, number | null];

/**
 * The first round of a bracket in the order of the programs: the first meets the last, the first two can meet in the final only,
 * and where there are too few the first ones go on without a match.
 */
export function firstRound(count: number): readonly Tie[] {
  let places: readonly number[] = [0];
  while (places.length < count) {
    const last = 2 * places.length - 1;
    places = places.flatMap((place, index) => (index % 2 === 0 ? [place, last - place] : [last - place, place]));
  }
  return tiesOf(places.map((place) => (place < count ? place : null)));
}

/** The pairs of the next round, of those that have gone on, in the order of the bracket. */
export const nextRound = (goOn: readonly number[]): readonly Tie[] => tiesOf(goOn);

function tiesOf(places: readonly (number | null)[]): readonly Tie[] {
  const ties: Tie[] = [];
  for (let index = 0; index < places.length; index += 2) {
    const [one = null, other = null] = places.slice(index, index + 2);
    if (one !== null && other !== null) ties.push([Math.min(one, other), Math.max(one, other)]);
    else if (one !== null || other !== null) ties.push([one ?? other ?? 0, null]);
  }
  return ties;
}

/** The one of a pair that goes on: by wins, then by the shorter time of all wins together, then the first in order. */
export function winnerOf([one, other]: Tie, matches: readonly Match[]): number {
  if (other === null) return one;
  const own = matches.filter(({ a, b }) => [a, b].includes(one) && [a, b].includes(other));
  const [here, there] = [scoreOf(one, own), scoreOf(other, own)];
  const lead = here.won - there.won || there.wonMs - here.wonMs;
  return lead >= 0 ? one : other;
}
