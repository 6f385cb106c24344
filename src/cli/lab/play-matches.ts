import { MATCH_END } from '#lab/tournament/match-setup';
import { resultOfRun, type MatchResult, type Pairing } from '#lab/tournament/match';
import type { Entry } from '#lab/tournament/file';
import { stageSetup } from '#lab/tournament/stage-setup';
import type { StagePlan } from '#lab/tournament/stages';
import { runMaker, type Wanted } from './make-runs';

/** Plays matches of a tournament side by side, in threads that live until it is stopped. */
export interface MatchPlayer {
  /** Plays some matches of a stage; `null`: one cannot be played, for the reason in `problem`. */
  play(plan: StagePlan, pairings: readonly Pairing[]): Promise<readonly MatchResult[] | null>;
  /** Why a match could not be played; empty: all could. */
  readonly problem: string;
  stop(): void;
}

/** @param ended called after each match */
export async function matchPlayer(
  entry: Pick<Entry, 'scene' | 'programs'>,
  jobs: number,
  ended: () => void,
): Promise<MatchPlayer> {
  const maker = await runMaker(jobs);
  let problem = '';
  return {
    async play(plan, pairings) {
      const results: MatchResult[] = [];
      const runs: Wanted<number>[] = [];
      for (const [place, pairing] of pairings.entries()) {
        const setup = stageSetup(entry, plan, pairing);
        if ('problem' in setup) problem = setup.problem;
        else runs.push({ is: place, request: { setup, end: MATCH_END } });
      }
      if (problem !== '') return null;
      const refused = await maker.make(runs, (place, made) => {
        results[place] = resultOfRun(made, plan.isAlone);
        ended();
      });
      if (refused !== null) problem = refused.problem;
      return refused === null ? results : null;
    },
    get problem() {
      return problem;
    },
    stop: () => maker.stop(),
  };
}
