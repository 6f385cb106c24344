import { describe, expect, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { parseSceneValue } from '#scene/parse';

import { comparedSum } from './compared-texts';
import { comparison, differences, parseTournament, tournamentFile, type Compared, type Entry } from './file';
import { looksLikeTournament } from './format';
import { inRounds, leaguePairings } from './league';
import type { MatchResult, Pairing } from './match';
import type { Draw } from './play';
import { finalistsOf, playedStages, type Stage } from './stages';
import { playedText } from './texts';

const names = ['a', 'b', 'c', 'd', 'e'];
const draw: Draw = { mode: 'league', names, seeds: [1, 2], isAlone: false };
/** The later one in the list of programs wins. */
const later = ({ a, b }: Pairing): MatchResult => ({ winner: a > (b ?? -1) ? 'a' : 'b', atMs: 1000, reason: 'left', traceHash: `${a}${b ?? ''}` }); // prettier-ignore

/** A tournament in which each stage knows its programs by their places in the whole. */
async function stagesOf(one: Draw): Promise<readonly Stage[]> {
  const found = await playedStages(one, ({ entrants }, _, pairings) =>
    Promise.resolve(
      pairings.map(({ a, b, seed }) => later({ a: entrants[a] ?? 0, b: b === null ? null : (entrants[b] ?? 0), seed })),
    ),
  );
  return found ?? [];
}

describe('a tournament with a final round', () => {
  it('plays it with the first of the league, with a seed of its own', async () => {
    const [league, finals] = await stagesOf(draw);
    expect(league?.table.map(({ name }) => name)).toEqual(['e', 'd', 'c', 'b', 'a']);
    expect(finals).toMatchObject({ mode: 'knockout', names: ['e', 'd', 'c', 'b'], seeds: [3], entrants: [4, 3, 2, 1] });
    expect(finals?.table[0]?.name).toBe('e');
  });
  it.each([
    [2, 0],
    [3, 2],
    [7, 4],
    [24, 8],
  ])('of %i programs has %i in it', (count, of) =>
    expect(finalistsOf({ ...draw, names: Array.from({ length: count }, String) })).toBe(of),
  );
  it('has none in a course for one robot, or where the brackets are all', async () => {
    expect(finalistsOf({ ...draw, isAlone: true })).toBe(0);
    expect(await stagesOf({ ...draw, mode: 'knockout' })).toHaveLength(1);
  });
});

describe('the rounds of a league', () => {
  it.each([4, 5])('of %i programs have nobody twice', (count) => {
    const all = inRounds([...leaguePairings(count, [1], false)], count);
    expect(all).toHaveLength(count * (count - 1));
    // Both sides of a pair follow each other.
    const inRound = 2 * Math.floor(count / 2);
    for (let from = 0; from < all.length; from += inRound) {
      const playing = all.slice(from, from + inRound).map(({ a }) => a);
      expect(new Set(playing).size).toBe(inRound);
    }
  });
});

describe('the file of a tournament', () => {
  const course = parseSceneValue({
    ...{ format: 'parcours-scene', version: 4, name: 'Ring', size: [1500, 1500] },
    ...{ robot: { at: [560, 700], heading: 0 }, task: { seconds: 60, robots: 'ring' } },
    objects: [
      { id: 'ring', type: 'target', at: [750, 750], size: [840, 840], round: true },
      { id: 'rival', type: 'start', at: [930, 820], heading: 180 },
    ],
  });
  if ('problem' in course) throw new Error(course.problem);
  const entry: Entry = {
    ...{ name: 'Ring', mode: 'league', seeds: [1, 2], scene: course.scene },
    programs: names.map((name) => ({ name, files: { 'main.py': `# ${name}\n` } })),
  };
  it('read again is the same tournament, and the same matches are equal to it', async () => {
    const stages = await stagesOf(draw);
    const read = parseTournament(tournamentFile(entry, stages));
    if ('problem' in read) throw new Error(read.problem);
    const { told, ...again } = read.tournament;
    expect(again).toEqual(entry);
    expect(differences(comparison(stages, told))).toBe(0);
  });
  it('tells how many matches come out otherwise', async () => {
    const stages = await stagesOf(draw);
    const changed = tournamentFile(entry, stages).replace('"a":"a","b":"b","seed":1,"winner":"b"', '"a":"a","b":"b","seed":1,"winner":"a"'); // prettier-ignore
    const read = parseTournament(changed);
    if ('problem' in read) throw new Error(read.problem);
    const compared = comparison(stages, read.tournament.told);
    expect(differences(compared)).toBe(1);
    expect(compared.matches.filter(({ isSame }) => !isSame)).toMatchObject([
      { stage: 0, now: { a: 'a', b: 'b', winner: 'b' }, told: { a: 'a', b: 'b', winner: 'a' } },
    ]);
  });
  it('says in words how many matches are unlike, one or several', () => {
    const match = (isSame: boolean): Compared => ({ stage: 0, now: {}, told: {}, isSame });
    const sum = (...all: readonly boolean[]): readonly string[] =>
      LANGUAGES.map((language) => comparedSum({ matches: all.map(match), areTablesSame: true }, language));
    expect(sum(false, true)[0]).toBe('1 von 2 Kämpfen ist anders ausgegangen, als es in der Datei steht.');
    expect(sum(false, false)[0]).toBe('2 von 2 Kämpfen sind anders ausgegangen, als es in der Datei steht.');
    expect(sum(true)[0]).toBe('Der eine Kampf ist ausgegangen, wie es in der Datei steht.');
    expect(LANGUAGES.map((language) => playedText(1, language))).toEqual(['1 Kampf', '1 combat', '1 incontro', '1 match']); // prettier-ignore
  });
  it('tells of a table that does not come of its matches', async () => {
    const stages = await stagesOf(draw);
    const read = parseTournament(tournamentFile(entry, stages).replaceAll('"points":24', '"points":25'));
    if ('problem' in read) throw new Error(read.problem);
    expect(comparison(stages, read.tournament.told).areTablesSame).toBe(false);
  });
  it('with more files of a program than a board has room for says so, and drops none', () => {
    const files = Object.fromEntries(Array.from({ length: 21 }, (_, place) => [`f${place}.py`, '']));
    const programs = entry.programs.map((one, place) => (place === 0 ? { ...one, files } : one));
    expect(parseTournament(tournamentFile({ ...entry, programs }, []))).toMatchObject({
      problem: expect.stringContaining('programs[0].files: 21 files are too many, at most 20.'),
    });
  });
  it.each([
    ['{', 'not JSON'],
    ['{"format":"parcours-project"}', 'not a tournament'],
    ['{"format":"parcours-tournament","version":2}', 'newer'],
    ['{"format":"parcours-tournament","version":1,"mode":"cup","seeds":[1],"programs":[],"stages":[]}', 'mode'],
  ])('%s is refused with the reason', (text, reason) => {
    const read = parseTournament(text);
    expect('problem' in read && read.problem).toContain(reason);
  });

  it('keeps of what it tells plain values alone, and what is no list of matches is refused', async () => {
    const deep = (depth: number): string => '['.repeat(depth) + ']'.repeat(depth);
    const text = tournamentFile(entry, await stagesOf(draw));
    const read = parseTournament(text.replace('"winner":"b"', `"winner":${deep(20_000)},"more":1`));
    if ('problem' in read) throw new Error(read.problem);
    const [first] = read.tournament.told[0]?.matches ?? [];
    expect([first?.['winner'], first?.['seed'], first && 'more' in first]).toEqual([null, 1, false]);
    for (const stages of [deep(20_000), '[{"matches":{},"table":[]}]', `[{"matches":[${deep(20_000)}],"table":[]}]`])
      expect(
        parseTournament(tournamentFile(entry, []).replace(/"stages": \[\s*\]/, `"stages": ${stages}`)),
      ).toMatchObject({
        problem: expect.stringMatching(/^stages/),
      });
  });

  const many = (count: number, more: Partial<Entry>): string =>
    tournamentFile({ ...entry, ...more, programs: Array.from({ length: count }, (_, at) => ({ name: `p${at}`, files: { 'main.py': '' } })) }, []); // prettier-ignore
  it('holds as many matches as are really played, and no more', () => {
    expect(parseTournament(many(200, { seeds: [1] }))).toHaveProperty('tournament');
    expect(parseTournament(many(200, { mode: 'knockout', seeds: [1, 2, 3, 4, 5] }))).toHaveProperty('tournament');
    expect(parseTournament(many(200, { seeds: [1, 2] }))).toEqual({
      problem: '79614 matches are too many, at most 50000.',
    });
    expect(parseTournament(many(201, { seeds: [1] }))).toHaveProperty('problem');
  });

  it('is known by its format alone', () => {
    expect(looksLikeTournament(tournamentFile(entry, []))).toBe(true);
    expect(looksLikeTournament('{"name":"parcours-tournament","format":"parcours-project"}')).toBe(false);
  });

  it('without a task that anybody could win is refused', () => {
    const { scene } = entry;
    const empty = parseSceneValue({ format: 'parcours-scene', version: 4, size: [900, 900] });
    const without = 'scene' in empty ? empty.scene : scene;
    expect(parseTournament(tournamentFile({ ...entry, scene: without }, []))).toMatchObject({ problem: expect.stringContaining('no task') }); // prettier-ignore
    const together = { ...scene, task: { ...scene.task, robots: 'together' } } as Entry['scene'];
    expect(parseTournament(tournamentFile({ ...entry, scene: together }, []))).toMatchObject({ problem: expect.stringContaining('together') }); // prettier-ignore
  });

  it('with brackets in a course for one is refused: there nobody meets', () => {
    const { robots: _, ...task } = entry.scene.task;
    const alone: Entry = { ...entry, mode: 'knockout', scene: { ...entry.scene, task } };
    expect(parseTournament(tournamentFile(alone, []))).toMatchObject({ problem: expect.stringContaining('league') });
  });
});
