import { existsSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { lastLine, parcours, useFolder } from '../testing/parcours';

const { folder, file } = useFolder();
const at = (name: string): string => join(folder, name);

/** Drives for a time, turns for another, and stops: lines 4 and 6. */
const turn = (driveMs: number, turnMs = 200): string =>
  `from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(${driveMs})\nright()\ndelay(${turnMs})\nstop()\n`;
const program = file('turn.py', turn(650));

interface Json {
  readonly varied: readonly string[];
  readonly runs: readonly {
    readonly values: readonly number[];
    readonly passed: boolean | null;
    readonly atMs: number | null;
    readonly reason: string | null;
    readonly traceHash: string;
  }[];
  readonly passed: number;
  readonly of: number;
}

const jsonOf = (text: string): Json => JSON.parse(text) as Json;

/** The fingerprint of `parcours run` of this program. */
const hashOf = (text: string, ...more: readonly string[]): string =>
  lastLine(parcours('run', file('one.py', text), '--json', '--quiet', ...more).out).traceHash;

const VARY = ['--vary', 'turn.py:4=400..800/200', '--vary', 'main.py:6=100,300'];

describe('parcours sweep', { timeout: 120_000 }, () => {
  const swept = parcours('sweep', program, ...VARY, '--json', '--jobs', '4').out;

  it('makes each run as parcours run makes it of the program with the numbers in it', () => {
    const { varied, runs, passed, of } = jsonOf(swept);
    expect(varied).toEqual(['turn.py:4', 'main.py:6']);
    expect(runs.map(({ values }) => values)).toEqual([[400, 100], [400, 300], [600, 100], [600, 300], [800, 100], [800, 300]]); // prettier-ignore
    expect({ passed, of }).toEqual({ passed: 0, of: 6 });
    expect(runs[3]).toMatchObject({ passed: null, reason: null, traceHash: hashOf(turn(600, 300)) });
    expect(Object.keys(runs[3] ?? {})).toEqual(
      ['values', 'passed', 'atMs', 'touches', 'reason', 'xMm', 'yMm', 'headingDeg', 'pathMm', 'traceHash'], // prettier-ignore
    );
  });

  it('is the same of one thread, and of seven shards that are joined from their folder, one file per run', () => {
    expect(parcours('sweep', program, ...VARY, '--json', '--jobs', '1').out).toBe(swept);
    const runs = at('runs');
    // One of them has nothing to run: six runs for seven.
    for (let shard = 1; shard <= 7; shard++)
      expect(
        parcours('sweep', program, ...VARY, '--resume', runs, '--shard', `${shard}/7`, '--quiet', '--jobs', '1').code,
      ).toBe(0);
    expect(readdirSync(join(runs, 'runs'))).toHaveLength(6);
    expect(parcours('sweep', '--merge', runs, '--json').out).toBe(swept);
    rmSync(join(runs, 'runs', '000002.json'));
    expect(parcours('sweep', '--merge', runs)).toMatchObject({ code: 2, err: expect.stringContaining('1 of 6 runs have no result yet') as string }); // prettier-ignore
    expect(parcours('sweep', program, ...VARY, '--resume', runs, '--json').out).toBe(swept);
    expect(parcours('sweep', program, ...VARY, '--resume', runs, '--for', '1s').err).toContain(
      'the runs of another sweep',
    );
  });

  it.each([
    ['--seed', '2'],
    ['--scene', 'slalom'],
    ['--senses', 'on'],
    ['--robot', 'none'],
    ['--jobs', '2'],
    ['--for', '1s'],
  ])('refuses %s beside --merge, which runs nothing', (option, value) => {
    const { code, err } = parcours('sweep', '--merge', at('runs'), option, value);
    expect(code).toBe(2);
    expect(err).toContain(`parcours: ${option} and --merge: choose one of them.`);
  });

  it('keeps runs of another seed apart in a folder of used robots', () => {
    const used = at('used');
    const words = ['sweep', program, '--vary', 'reality=0.5,1', '--for', '100ms', '--resume', used, '--quiet'];
    expect(parcours(...words).code).toBe(0);
    expect(parcours(...words, '--seed', '1').code).toBe(0);
    expect(parcours(...words, '--seed', '2').err).toContain('the runs of another sweep');
  });

  it('ends with the task in a course that has one, and writes table and page', () => {
    const course = {
      ...{ format: 'parcours-scene', version: 1, size: [1200, 900], robot: { at: [200, 450] } },
      objects: [{ id: 'goal', type: 'target', at: [500, 450], size: [120, 300] }],
    };
    const [scene, csv, report] = [file('goal.json', JSON.stringify(course)), at('r.csv'), at('r.html')];
    const words = ['--scene', scene, '--vary', 'main.py:4=500,3000', '--csv', csv, '--report', report, '--json'];
    const { out, code } = parcours('sweep', program, ...words);
    const { runs, passed } = jsonOf(out);
    expect(code).toBe(0);
    expect(runs).toMatchObject([
      { passed: false, atMs: null, reason: 'open', traceHash: hashOf(turn(500), '--scene', scene, '--until-verdict') },
      { passed: true, reason: null, traceHash: hashOf(turn(3000), '--scene', scene, '--until-verdict') },
    ]);
    expect(passed).toBe(1);
    expect(readFileSync(csv, 'utf8').split('\r\n')[1]).toMatch(/^500,0,,0,open,/);
    expect(readFileSync(report, 'utf8')).toMatch(/<h1>Sweep: turn\.py<\/h1>[^]*1 of 2 runs passed[^]*class="ring"/);
  });

  it.each([
    [['main.py:1=1'], '--vary main.py:1: there is no number in this line: from mbrobot import *'],
    [['speed=1'], '--vary speed: is not known.'],
    [['main.py:4=1..400#400', 'seed=1..300/1'], '120000 runs are too many'],
    [['start.x=600,5'], 'start.x=5: robot.at: at [5, 450]'],
  ])('ends with 2 for %j', (vary, problem) => {
    const words = vary.flatMap((one) => ['--vary', one]);
    const { code, out, err } = parcours('sweep', program, ...words, '--resume', at('none'), '--quiet');
    expect({ code, out }).toEqual({ code: 2, out: '' });
    expect(err).toContain(problem);
    expect(existsSync(at('none/runs/000003.json'))).toBe(false);
  });
});
