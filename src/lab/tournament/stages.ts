import type { Match, MatchResult, Pairing } from './match';
import { matchCount, played, type Draw } from './play';
import type { Row } from './table';

/** A part of a tournament with a table of its own. */
export interface StagePlan extends Draw {
  /** The programs in it, by their places in the tournament, in the order of the stage. */
  readonly entrants: readonly number[];
}

/** A stage that was played. Its matches name programs by their places among the entrants. */
export interface Stage extends StagePlan {
  readonly matches: readonly Match[];
  readonly table: readonly Row[];
}

/** Most programs of a final round. Chosen: three rounds fit beside the table. */
const MOST_FINALISTS = 8;

/** The number of programs that go on from a league into a final round: 8, 4 or 2; 0: there is none. */
export function finalistsOf({ mode, names, isAlone }: Draw): number {
  if (mode === 'knockout' || isAlone || names.length < 3) return 0;
  let count = 2;
  while (2 * count <= Math.min(names.length, MOST_FINALISTS)) count *= 2;
  return count;
}

/** Number of matches with those of the final round; of brackets fewer may be played. */
export const wholeCount = (draw: Draw): number => matchCount(draw) + 2 * Math.max(0, finalistsOf(draw) - 1);

/** The first stage of a tournament: all of its programs. */
export const firstStage = (draw: Draw): StagePlan => ({ ...draw, entrants: draw.names.map((_, place) => place) });

/**
 * The final round after a league, with the first of its table so far; `null`: there is none. It has the seed after those of the
 * league: with the same one each match would be played again as it was.
 */
export function finalStage(league: StagePlan, table: readonly Row[]): StagePlan | null {
  const count = finalistsOf(league);
  if (count === 0) return null;
  const names = table.slice(0, count).map(({ name }) => name);
  const seeds = [Math.max(0, ...league.seeds) + 1];
  return { mode: 'knockout', names, seeds, isAlone: false, entrants: names.map((name) => league.names.indexOf(name)) };
}

/** Plays some matches of a stage, side by side; `null`: they were not played. */
export type PlayStage = (
  plan: StagePlan,
  place: number,
  pairings: readonly Pairing[],
) => Promise<readonly MatchResult[] | null>;

/** Plays a tournament with its final round. */
export async function playedStages(draw: Draw, play: PlayStage): Promise<readonly Stage[] | null> {
  const stages: Stage[] = [];
  for (let plan: StagePlan | null = firstStage(draw); plan !== null;) {
    const now: StagePlan = plan;
    const found = await played(now, (pairings) => play(now, stages.length, pairings));
    if (found === null) return null;
    const { matches, table } = found;
    stages.push({ ...now, matches, table });
    plan = stages.length === 1 ? finalStage(now, table) : null;
  }
  return stages;
}
