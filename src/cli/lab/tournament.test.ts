import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { describe, expect, it } from 'vitest';
import { secondsText } from '#check/report/texts';
import { drawOf, tournamentFile, type Entry } from '#lab/tournament/file';
import type { Match } from '#lab/tournament/match';
import { firstStage } from '#lab/tournament/stages';
import { tableOf } from '#lab/tournament/table';
import { parseScene } from '#scene/parse';
import { parcours, useFolder } from '../testing/parcours';

const { file } = useFolder();

/** Two robots in a ring, for five seconds; both are Maqueens, whatever the programs import. */
const ring = file(
  'ring.json',
  JSON.stringify({
    ...{ format: 'parcours-scene', version: 7, size: [1200, 900] },
    robot: { type: 'maqueen-lite', at: [450, 450], heading: 0 },
    task: { robots: 'ring', seconds: 5 },
    objects: [
      { id: 'ring', type: 'target', at: [600, 450], size: [700, 500] },
      { id: 'start', type: 'start', at: [750, 450], heading: 180, robot: 'maqueen-lite' },
    ],
  }),
);
const leaves = file('leaves.py', 'from mbrobot import *\nsetSpeed(100)\nbackward()\ndelay(9000)\n');
const stays = file('stays.py', 'from callibot import *\n');

/** A match with the names of its programs, as a file has it. */
type NamedMatch = Omit<Match, 'a' | 'b'> & { readonly a: string; readonly b: string };

describe('parcours tournament', { timeout: 120_000 }, () => {
  it('plays each pair on both sides, the same with one and with four threads', () => {
    const [one, four] = ['1', '4'].map((jobs) => parcours('tournament', ring, leaves, stays, '--json', '--jobs', jobs));
    expect(one).toEqual(four);
    expect(one?.err).toBe('');
    const { mode, matches, table } = JSON.parse(one?.out ?? '') as Record<string, readonly object[]>;
    expect(mode).toBe('league');
    expect(matches).toMatchObject([
      { a: 'leaves.py', b: 'stays.py', seed: 1, winner: 'b', reason: 'left' },
      { a: 'stays.py', b: 'leaves.py', seed: 1, winner: 'a', reason: 'left' },
    ]);
    expect(table).toEqual([
      { name: 'stays.py', points: 6, won: 2, drawn: 0, lost: 0 },
      { name: 'leaves.py', points: 0, won: 0, drawn: 0, lost: 2 },
    ]);
  });

  it('writes a page and a table of a knockout', () => {
    const [report, csv] = [file('t.html', ''), file('t.csv', '')];
    const { out } = parcours('tournament', ring, stays, leaves, '--mode', 'knockout', '--report', report, '--csv', csv);
    expect(out).toBe('1. stays.py  6  (2/0/0)\n2. leaves.py  0  (0/0/2)\n2 matches\n');
    expect(readFileSync(csv, 'utf8')).toBe('name,points,won,drawn,lost\r\nstays.py,6,2,0,0\r\nleaves.py,0,0,0,2\r\n');
    expect(readFileSync(report, 'utf8')).toContain('<td>stays.py</td><td class="number">6</td>');
  });

  it('plays a tournament of a file again, and says match by match whether it comes out the same', () => {
    const scene = parseScene(readFileSync(ring, 'utf8'));
    if ('problem' in scene) throw new Error(scene.problem);
    const programs = [leaves, stays].map((path) => ({
      name: basename(path),
      files: { 'main.py': readFileSync(path, 'utf8') },
    }));
    const entry: Entry = { name: 'Ring', scene: scene.scene, programs, mode: 'league', seeds: [1] };
    const unplayed = file('unplayed.json', tournamentFile(entry, []));
    const missing = parcours('tournament', '--verify', unplayed, '--json');
    expect(missing.code).toBe(1);
    const names = programs.map(({ name }) => name);
    const { matches } = JSON.parse(missing.out) as { readonly matches: readonly { readonly now: NamedMatch }[] };
    const played = matches.map(({ now }): Match => ({ ...now, a: names.indexOf(now.a), b: names.indexOf(now.b) }));
    const table = tableOf(names, played);
    const text = tournamentFile(entry, [{ ...firstStage(drawOf(entry)), matches: played, table }]);
    const kept = file('kept.json', text);
    const again = parcours('tournament', '--verify', kept);
    const [one = '', other = ''] = played.map(({ atMs }) => secondsText(atMs ?? 0));
    expect(again.out).toBe(
      `leaves.py – stays.py (1)  stays.py wins, ${one}, left the ring  the same\n` +
        `stays.py – leaves.py (1)  stays.py wins, ${other}, left the ring  the same\n` +
        'All 2 matches came out as the file says.\n',
    );
    expect([again.err, again.code]).toEqual(['', 0]);
    const forged = parcours(
      'tournament',
      '--verify',
      file('forged.json', text.replace('"winner":"b"', '"winner":"a"')),
    );
    expect(forged.code).toBe(1);
    expect(forged.out).toContain('stays.py wins, ');
    expect(forged.out).toContain('otherwise, the file says: leaves.py wins');
    expect(forged.out).toContain('1 of 2 matches came out otherwise than the file says.');
  });

  it('refuses a file whose matches are lists within lists', () => {
    const scene = parseScene(readFileSync(ring, 'utf8'));
    if ('problem' in scene) throw new Error(scene.problem);
    const programs = ['a', 'b'].map((name) => ({ name, files: { 'main.py': '' } }));
    const text = tournamentFile({ name: 'Ring', scene: scene.scene, programs, mode: 'league', seeds: [1] }, []);
    const deep = `[{"matches":[${'['.repeat(20_000)}${']'.repeat(20_000)}],"table":[]}]`;
    const path = file('deep.json', text.replace(/"stages": \[[^\]]*\]/, `"stages": ${deep}`));
    const { code, err } = parcours('tournament', '--verify', path, '--json');
    expect([code, err]).toEqual([2, expect.stringContaining('stages[0].matches[0]: must be an object')]);
  });

  it.each([
    [[ring, stays], 'has nobody to meet'],
    [['slalom', stays, leaves, '--mode', 'knockout'], 'a course for one robot'],
    [['empty', stays, leaves], 'has no task'],
    [[ring, stays, leaves, '--seeds', '1,1'], '--seeds: "1,1" is not like 1,2,3'],
    [[ring, stays, 'nobody.py'], 'nobody.py'],
    [['--verify', ring], 'is not a tournament'],
    [['--verify', ring, stays], '--verify plays what is in its file'],
    [['--verify', ring, '--seeds', '1'], '--seeds and --verify: choose one of them'],
  ])('ends with 2 for %j', (words, problem) => {
    const { code, err } = parcours('tournament', ...words);
    expect(code).toBe(2);
    expect(err).toContain(problem);
  });
});
