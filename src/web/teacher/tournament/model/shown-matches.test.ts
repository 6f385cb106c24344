import { describe, expect, it } from 'vitest';

import type { Match } from '#lab/tournament/match';

import { playsIn, shownMatches } from './shown-matches';
import { standingOf } from './standing';
import type { LiveStage } from './tournament-model';

const match = (a: number, b: number, winner: Match['winner']): Match => ({ a, b, seed: 1, winner, atMs: 1000, reason: 'left' }); // prettier-ignore
const stage = (mode: LiveStage['mode'], names: readonly string[], ended: readonly Match[], entrants: readonly number[]): LiveStage => ({ mode, names, entrants, seeds: [1], isAlone: false, ended, matches: ended, of: names.length * (names.length - 1) }); // prettier-ignore

describe('the matches that can be watched', () => {
  const league = stage('league', ['x', 'y', 'z'], [match(1, 2, 'a'), match(0, 1, 'b')], [0, 1, 2]);
  const finals = stage('knockout', ['y', 'z'], [match(0, 1, 'a'), match(1, 0, 'b')], [1, 2]);
  it('are numbered in a league as they have ended, and have their round and pair in brackets', () => {
    const all = shownMatches([league, finals]);
    expect(all.map(({ number, tie }) => [number, tie?.beforeFinal ?? null])).toEqual([[1, null], [2, null], [1, 0], [2, 0]]); // prettier-ignore
    expect(new Set(all.map(({ key }) => key)).size).toBe(4);
  });
  it('of one program are those in which it plays, whatever its place in the stage', () => {
    const of = (program: number): number =>
      shownMatches([league, finals]).filter((one) => playsIn(one, program)).length;
    expect([of(0), of(1), of(2)]).toEqual([1, 4, 3]);
  });
});

describe('the table as it stands', () => {
  it('tells how many places a program has won lately, until the last match', () => {
    const ended = [match(0, 1, 'a'), match(0, 2, 'a'), match(1, 2, 'b'), match(2, 0, 'a'), match(2, 1, 'a')];
    const rises = (of: number) => standingOf({ ...stage('league', ['x', 'y', 'z'], ended, [0, 1, 2]), of }).map(({ name, rise }) => [name, rise]); // prettier-ignore
    expect(rises(6)).toEqual([
      ['z', 2],
      ['x', 0],
      ['y', 0],
    ]);
    expect(rises(5).every(([, rise]) => rise === 0)).toBe(true);
  });
});
