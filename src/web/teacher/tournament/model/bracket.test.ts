import { describe, expect, it } from 'vitest';

import type { Match } from '#lab/tournament/match';

import { bracketOf } from './bracket';

const match = (a: number, b: number, winner: Match['winner'] = 'a', atMs = 1000): Match => ({ a, b, seed: 1, winner, atMs, reason: 'left' }); // prettier-ignore
const entrants = (rounds: ReturnType<typeof bracketOf>) =>
  rounds.map((round) => round.map(({ sides }) => sides.map(({ entrant }) => entrant)));

describe('a bracket', () => {
  it('has all of its rounds before a match is played', () => {
    const rounds = bracketOf(8, [], 2);
    expect(entrants(rounds)).toEqual([
      [[0, 7], [3, 4], [2, 5], [1, 6]],
      [[null, null], [null, null]],
      [[null, null]],
    ]); // prettier-ignore
    expect(rounds.flat().every(({ winner }) => winner === null)).toBe(true);
  });
  it('shows who goes on as soon as a pair is decided, with the wins of both', () => {
    const rounds = bracketOf(4, [match(0, 3), match(3, 0), match(1, 2)], 2);
    expect(rounds[0]?.[0]).toMatchObject({ sides: [{ wins: 1 }, { wins: 1 }], winner: 0 });
    expect(rounds[0]?.[1]).toMatchObject({ sides: [{ wins: 1 }, { wins: 0 }], winner: null });
    expect(entrants(rounds)[1]).toEqual([[0, null]]);
  });
  it('lets the first go on where there is nobody to meet', () => {
    const rounds = bracketOf(3, [], 2);
    expect(rounds[0]?.map(({ isBye, winner }) => [isBye, winner])).toEqual([
      [true, 0],
      [false, null],
    ]);
    expect(entrants(rounds)[1]).toEqual([[0, null]]);
  });
  it('ends with the final', () => {
    const semis = [match(0, 3), match(3, 0, 'b'), match(1, 2, 'b'), match(2, 1)];
    const rounds = bracketOf(4, [...semis, match(0, 2), match(2, 0, 'draw')], 2);
    expect(rounds.at(-1)).toMatchObject([{ sides: [{ entrant: 0, wins: 1 }, { entrant: 2, wins: 0 }], winner: 0 }]); // prettier-ignore
  });
  it('of one program has no rounds', () => expect(bracketOf(1, [], 2)).toEqual([]));
});
