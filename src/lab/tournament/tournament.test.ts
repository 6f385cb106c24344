import { describe, expect, it } from 'vitest';
import type { Outcome } from '../outcome';
import { firstRound } from './knockout';
import { resultOfRun, type MatchResult, type Pairing } from './match';
import { programNames } from './names';
import { played, type Mode, type Tournament } from './play';
import { tournamentJson } from './texts';

/** A tournament in which the lower number always wins, in 10 s less for each place between them. */
const lower = ({ a, b }: Pairing): MatchResult => ({
  winner: b === null || a < b ? 'a' : 'b',
  atMs: 60_000 - 10_000 * Math.abs(a - (b ?? a)),
  reason: 'left',
});

async function playedBy(
  mode: Mode,
  names: readonly string[],
  result: (pairing: Pairing) => MatchResult,
  { seeds = [1], isAlone = false } = {},
): Promise<{ readonly found: Tournament; readonly rounds: readonly (readonly Pairing[])[] }> {
  const rounds: (readonly Pairing[])[] = [];
  const found = await played({ mode, names, seeds, isAlone }, (pairings) => {
    rounds.push(pairings);
    return Promise.resolve(pairings.map(result));
  });
  if (found === null) throw new Error('not played');
  return { found, rounds };
}

describe('a league', () => {
  it('plays each pair twice per seed, once on each side', async () => {
    const { rounds } = await playedBy('league', ['x', 'y', 'z'], lower, { seeds: [4, 5] });
    expect(rounds[0]?.map(({ a, b, seed }) => `${a}${b ?? ''}:${seed}`)).toEqual(
      ['01:4', '10:4', '01:5', '10:5', '02:4', '20:4', '02:5', '20:5', '12:4', '21:4', '12:5', '21:5'], // prettier-ignore
    );
  });

  it('gives 3 points for a win and 1 for a draw, and orders by points, wins, time of the wins, order', async () => {
    const { found } = await playedBy('league', ['x', 'y', 'z'], (pairing) =>
      pairing.a + (pairing.b ?? 0) === 1 ? { winner: 'draw', atMs: 60_000, reason: 'time' } : lower(pairing),
    );
    expect(found.table).toEqual([
      { name: 'x', points: 8, won: 2, drawn: 2, lost: 0 },
      { name: 'y', points: 8, won: 2, drawn: 2, lost: 0 },
      { name: 'z', points: 0, won: 0, drawn: 0, lost: 4 },
    ]);
  });

  it('runs each program alone in a course for one, and says in how many runs it has passed', async () => {
    const { found } = await playedBy('league', ['x', 'y'], ({ a }) => ({ winner: a === 1 ? 'a' : 'b', atMs: null, reason: 'open' }), { isAlone: true }); // prettier-ignore
    expect(JSON.parse(tournamentJson(found))).toEqual({
      mode: 'league',
      matches: [
        { a: 'x', b: null, seed: 1, winner: 'b', atMs: null, reason: 'open' },
        { a: 'y', b: null, seed: 1, winner: 'a', atMs: null, reason: 'open' },
      ],
      table: [
        { name: 'y', points: 3, won: 1, drawn: 0, lost: 0, passed: 1 },
        { name: 'x', points: 0, won: 0, drawn: 0, lost: 1, passed: 0 },
      ],
    });
  });
});

describe('a knockout', () => {
  it.each([
    [2, [[0, 1]]],
    [3, [[0, null], [1, 2]]],
    [4, [[0, 3], [1, 2]]],
    [5, [[0, null], [3, 4], [2, null], [1, null]]],
    [8, [[0, 7], [3, 4], [2, 5], [1, 6]]],
  ])('of %i has its byes for the first, who meet last', (count, ties) => expect(firstRound(count)).toEqual(ties)); // prettier-ignore

  it('goes on with those that win, and has the last one on top', async () => {
    const higher = (pairing: Pairing): MatchResult => {
      const result = lower(pairing);
      return { ...result, winner: result.winner === 'a' ? 'b' : 'a' };
    };
    const { found, rounds } = await playedBy('knockout', ['w', 'x', 'y', 'z'], higher);
    expect(rounds.map((pairings) => pairings.map(({ a, b }) => [a, b]))).toEqual([
      [[0, 3], [3, 0], [1, 2], [2, 1]],
      [[2, 3], [3, 2]],
    ]); // prettier-ignore
    expect(found.table.map(({ name }) => name)).toEqual(['z', 'y', 'w', 'x']);
  });

  it('decides equal wins by the time of the wins, and then by the order', async () => {
    const firstSide = (faster: number) => ({ a }: Pairing): MatchResult => ({ winner: 'a', atMs: a === faster ? 1000 : 2000, reason: 'left' }); // prettier-ignore
    const champion = async (result: (pairing: Pairing) => MatchResult): Promise<string | undefined> =>
      (await playedBy('knockout', ['x', 'y'], result)).found.table[0]?.name;
    expect(await champion(firstSide(1))).toBe('y');
    expect(await champion(firstSide(2))).toBe('x');
    expect(await champion(() => ({ winner: 'draw', atMs: null, reason: 'open' }))).toBe('x');
  });
});

describe('the result of a match', () => {
  const outcome = { passed: false, atMs: 5000, touches: 0, reason: null } as Outcome;
  const robot = (state: 'open' | 'passed' | 'failed', atMs: number | null = null, reason: string | null = null) => ({ state, atMs, reason }); // prettier-ignore
  type Given = Parameters<typeof resultOfRun>[0];
  const resultOf = (a: object, b: object) =>
    resultOfRun({ outcome, verdict: { atMs: 5000, robots: [a, b] } as unknown as Given['verdict'] }, false);

  it.each([
    ['the one that is left in the ring', robot('passed', 5000), robot('failed', 5000, 'left'), 'a', 'left'],
    ['the one that is not out', robot('failed', 2000, 'touched'), robot('open'), 'b', 'touched'],
    ['the earlier one of two that have arrived', robot('passed', 5000), robot('passed', 4000), 'b', 'beaten'],
    ['nobody when both are in the ring at the end', robot('passed', 5000), robot('passed', 5000), 'draw', 'time'],
    ['nobody when both are out', robot('failed', 1000, 'left'), robot('failed', 5000, 'left'), 'draw', 'time'],
  ])('is a win for %s', (_, a, b, winner, reason) => expect(resultOf(a, b)).toEqual({ winner, atMs: 5000, reason }));
});

describe('the names of programs', () => {
  it.each([
    [['/c/anna.py', '/c/ben.py'], ['anna.py', 'ben.py']],
    [['/c/8a/anna.py', '/c/8b/anna.py', '/c/8b/ben.py'], ['8a/anna.py', '8b/anna.py', 'ben.py']],
    [['/x/8a/anna.py', '/y/8a/anna.py'], ['x/8a/anna.py', 'y/8a/anna.py']],
    [['/c/anna.py', '/c/anna.py'], ['c/anna.py', 'c/anna.py (2)']],
  ])('of %j are %j', (paths, names) => expect(programNames(paths)).toEqual(names)); // prettier-ignore
});
