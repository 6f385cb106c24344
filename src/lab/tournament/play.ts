import { firstRound, nextRound, winnerOf } from './knockout';
import { leaguePairings, meeting } from './league';
import type { Match, MatchResult, Pairing } from './match';
import { tableOf, type Row } from './table';

export const modes = ['league', 'knockout'] as const;
export type Mode = (typeof modes)[number];

/** A tournament that was played. */
export interface Tournament {
  readonly mode: Mode;
  readonly names: readonly string[];
  /** In their order, which does not depend on when each has ended. */
  readonly matches: readonly Match[];
  readonly table: readonly Row[];
}

/** The programs and the mode. */
export interface Draw {
  readonly mode: Mode;
  readonly names: readonly string[];
  readonly seeds: readonly number[];
  /** True: the course is for one robot. */
  readonly isAlone: boolean;
}

/** Plays some matches, side by side; `null`: a match could not be played. */
export type Play = (pairings: readonly Pairing[]) => Promise<readonly MatchResult[] | null>;

/** Plays a tournament: a league at once, a knockout round by round. */
export async function played(draw: Draw, play: Play): Promise<Tournament | null> {
  const { mode, names, seeds, isAlone } = draw;
  if (mode === 'knockout') return playedOff(draw, play);
  const matches = await playedOf(Array.from(leaguePairings(names.length, seeds, isAlone)), play);
  return matches && { mode, names, matches, table: tableOf(names, matches) };
}

async function playedOff({ mode, names, seeds }: Draw, play: Play): Promise<Tournament | null> {
  const matches: Match[] = [];
  const reached = names.map(() => 0);
  for (let ties = firstRound(names.length); ;) {
    const pairings = ties.flatMap(([one, other]) => (other === null ? [] : meeting(one, other, seeds)));
    const now = await playedOf(pairings, play);
    if (now === null) return null;
    matches.push(...now);
    const goOn = ties.map((tie) => winnerOf(tie, now));
    for (const place of goOn) reached[place] = (reached[place] ?? 0) + 1;
    if (goOn.length < 2) return { mode, names, matches, table: tableOf(names, matches, reached) };
    ties = nextRound(goOn);
  }
}

async function playedOf(pairings: readonly Pairing[], play: Play): Promise<readonly Match[] | null> {
  const results = await play(pairings);
  return (
    results &&
    results.flatMap((result, place) => {
      const pairing = pairings[place];
      return pairing === undefined ? [] : [{ ...pairing, ...result }];
    })
  );
}

const leagueCount = ({ names: { length }, seeds, isAlone }: Draw): number =>
  seeds.length * (isAlone ? length : length * (length - 1));

/** Number of matches. */
export const matchCount = (draw: Draw): number =>
  draw.mode === 'league' ? leagueCount(draw) : 2 * draw.seeds.length * (draw.names.length - 1);
