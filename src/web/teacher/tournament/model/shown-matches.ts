import type { Match } from '#lab/tournament/match';

import { bracketOf, type BracketRound } from './bracket';
import type { LiveStage } from './tournament-model';

/** A match that can be watched. */
export interface ShownMatch {
  /** Unique among all of a tournament. */
  readonly key: string;
  readonly stage: LiveStage;
  readonly match: Match;
  /** The number of a match of a league, in the order in which they have ended. */
  readonly number: number;
  /** Its place in a bracket: how many rounds before the final, its pair of those of the round, its match of those of the pair. */
  readonly tie: {
    readonly beforeFinal: number;
    readonly pair: number;
    readonly of: number;
    readonly match: number;
  } | null;
}

/** Number of matches of a pair of a stage. */
export const matchesOfPair = ({ seeds }: Pick<LiveStage, 'seeds'>): number => 2 * seeds.length;

/** The rounds of a knockout as it stands. */
export const roundsOf = (stage: Pick<LiveStage, 'names' | 'matches' | 'seeds'>): readonly BracketRound[] =>
  bracketOf(stage.names.length, stage.matches, matchesOfPair(stage));

/** All matches that have ended: those of a league in the order in which they have, those of brackets by rounds and pairs. */
export function shownMatches(stages: readonly LiveStage[]): readonly ShownMatch[] {
  return stages.flatMap((stage, place): readonly ShownMatch[] => {
    const keyOf = ({ a, b, seed }: Match): string => [place, a, b, seed].join();
    if (stage.mode === 'league')
      return stage.ended.map((match, at) => ({ key: keyOf(match), stage, match, number: at + 1, tie: null }));
    const rounds = roundsOf(stage);
    return rounds.flatMap((round, at) =>
      round.flatMap(({ matches }, pair) =>
        matches.map((match, number) => ({
          ...{ key: keyOf(match), stage, match, number: number + 1 },
          tie: { beforeFinal: rounds.length - 1 - at, pair, of: round.length, match: number },
        })),
      ),
    );
  });
}

/** True if a program plays in a match, by its place in the tournament. */
export const playsIn = ({ stage, match }: ShownMatch, program: number): boolean =>
  stage.entrants[match.a] === program || (match.b !== null && stage.entrants[match.b] === program);
