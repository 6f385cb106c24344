import { firstRound, nextRound, winnerOf, type Tie } from '#lab/tournament/knockout';
import type { Match } from '#lab/tournament/match';
import { scoreOf } from '#lab/tournament/table';

/** A side of a pair: a program by its place among the entrants, `null` while it is open, and its wins so far. */
export interface Side {
  readonly entrant: number | null;
  readonly wins: number;
}

/** A pair of a round as it stands. */
export interface BracketTie {
  readonly sides: readonly [Side, Side];
  /** Its matches so far. */
  readonly matches: readonly Match[];
  /** The one that goes on; `null`: not decided. */
  readonly winner: number | null;
  /** The first goes on without a match: there is no second. */
  readonly isBye: boolean;
}

/** A round of a bracket, from the top. */
export type BracketRound = readonly BracketTie[];

/**
 * The rounds of a bracket as it stands, up to the final.
 *
 * @param ofEach number of matches of a pair
 */
export function bracketOf(count: number, matches: readonly Match[], ofEach: number): readonly BracketRound[] {
  if (count < 2) return [];
  const rounds: BracketRound[] = [];
  let ties: readonly (Tie | readonly [number | null, number | null, 'open'])[] = firstRound(count);
  for (;;) {
    const round = ties.map((tie) => (tie.length === 3 ? openTie(tie) : playedTie(tie, matches, ofEach)));
    rounds.push(round);
    if (round.length < 2) return rounds;
    const goOn = round.map(({ winner }) => winner);
    ties = goOn.every((one) => one !== null) ? nextRound(goOn) : openPairs(goOn);
  }
}

/** The pairs of a round of which not all are known: those that are play, the others stay open. */
function openPairs(
  goOn: readonly (number | null)[],
): readonly (Tie | readonly [number | null, number | null, 'open'])[] {
  return Array.from({ length: goOn.length / 2 }, (_, place) => {
    const [one = null, other = null] = goOn.slice(2 * place, 2 * place + 2);
    return one === null || other === null ? [one, other, 'open'] : [Math.min(one, other), Math.max(one, other)];
  });
}

const openTie = ([one, other]: readonly [number | null, number | null, 'open']): BracketTie => ({
  sides: [
    { entrant: one, wins: 0 },
    { entrant: other, wins: 0 },
  ],
  ...{ matches: [], winner: null, isBye: false },
});

function playedTie(tie: Tie, matches: readonly Match[], ofEach: number): BracketTie {
  const [one, other] = tie;
  const own = other === null ? [] : matches.filter(({ a, b }) => [a, b].includes(one) && [a, b].includes(other));
  const side = (entrant: number | null): Side => ({ entrant, wins: entrant === null ? 0 : scoreOf(entrant, own).won });
  return {
    sides: [side(one), side(other)],
    matches: own,
    winner: other === null || own.length === ofEach ? winnerOf(tie, own) : null,
    isBye: other === null,
  };
}

/** How many rounds each entrant has won so far: what decides its place first. */
export const reachedIn = (rounds: readonly BracketRound[], count: number): readonly number[] =>
  Array.from({ length: count }, (_, entrant) => rounds.filter((round) => round.some(({ winner }) => winner === entrant)).length); // prettier-ignore
