import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { parseCommand } from '../arguments';
import { readyProject } from '../ready-courses';
import { parcours, useFolder } from '../testing/parcours';

const { folder, file } = useFolder();

const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');
const NOTHING = 'x = 1\n';

/** A class's hand-ins in a folder of their own. */
function handIns(name: string, programs: Readonly<Record<string, string>>): string {
  mkdirSync(join(folder, name), { recursive: true });
  for (const [path, text] of Object.entries(programs)) writeFileSync(join(folder, name, path), text);
  return join(folder, name);
}

const classAct = (...args: readonly string[]): ReturnType<typeof parcours> => parcours('class', ...args);

describe('parcours class', () => {
  it('keeps a class over three weeks in one file: a list, hand-ins of two tasks, a second copy, a report', () => {
    const own = join(folder, '8b.json');
    const list = file('list.csv', 'Vorname;Name\nAda;Meier\nBen;Huber\nCleo;Roth\n');
    const set = classAct('set', own, '--name', 'Klasse 8b', '--names', list, '--scale', 'ch6', '--lang', 'de');
    expect(set).toEqual({
      code: 0,
      out: 'Klasse 8b · Schülerinnen und Schüler: 3 · Aufgaben: 0 · Abgaben: 0\n',
      err: '',
    });

    const first = handIns('first', { 'meier_ada.py': RIGHT, 'ben.py': NOTHING, 'cleo roth.docx': 'PK' });
    const added = classAct('add', own, 'closed-line', first, '--date', '2026-11-02', '--lang', 'de');
    expect(added.out).toBe('Klasse 8b – Geschlossene Linie: 3 neue Abgaben, 1 von 3 bestanden, 0 fehlen noch.\n');
    cpSync(own, join(folder, 'copy.json'));

    const second = handIns('second', { 'Ada M.py': NOTHING, 'Zoe.py': RIGHT });
    const more = classAct('add', own, 'closed-line', second, '--date', '2026-11-09');
    expect(more.out.split('\n')).toEqual([
      ...['Klasse 8b – Closed line: 2 new hand-ins, 1 of 2 passed, 0 still missing.', 'Not on the list: Zoe', ''],
    ]);
    const copy = classAct('add', join(folder, 'copy.json'), 'slalom', handIns('third', { 'Ben Huber.py': NOTHING }), '--date', '2026-11-16'); // prettier-ignore
    expect(copy.out).toContain('No hand-in yet: Ada Meier, Cleo Roth');
    expect(classAct('merge', own, join(folder, 'copy.json')).out).toBe(
      'Klasse 8b · Pupils: 4 · Tasks: 2 · Hand-ins: 6\n',
    );
    const once = readFileSync(own, 'utf8');
    classAct('merge', own, join(folder, 'copy.json'));
    expect(readFileSync(own, 'utf8')).toBe(once);

    const [report, csv] = [join(folder, '8b.html'), join(folder, '8b.csv')];
    const told = classAct('report', own, '--report', report, '--csv', csv, '--lang', 'de', '--date', '2026-11-30');
    expect(told.out.split('\n').slice(1)).toEqual([
      'Ada Meier  ✓ 1  – fehlt  1/2  3.5',
      'Ben Huber  ✗ 0  ✗ 0  0/2  1.0',
      'Cleo Roth  ? nicht lesbar  – fehlt  0/1  1.0',
      'Zoe  ✓ 1  – fehlt  1/2  3.5',
      '',
    ]);
    expect(readFileSync(csv, 'utf8').split('\r\n')[1]).toMatch(/^Ada Meier;1;.*;fehlt;.*;1;2;3,5$/);
    classAct('report', own, '--csv', csv, '--lang', 'de', '--decimals', 'point');
    expect(readFileSync(csv, 'utf8').split('\r\n')[1]).toMatch(/^Ada Meier;1;.*;fehlt;.*;1;2;3\.5$/);
    expect(readFileSync(report, 'utf8')).toContain('<th>Ada Meier</th><td class="passed">✓ 1 / 1');
    expect(JSON.parse(classAct('report', own, '--json').out)).toMatchObject({
      name: 'Klasse 8b',
      pupils: [{ name: 'Ada Meier', points: 1, most: 2, grade: 3.5, tasks: [{ state: 'passed', tries: 2 }, { state: 'missing', points: null }] }, {}, {}, {}], // prettier-ignore
    });
  });

  it('sorts hand-ins to the tasks of a series that they were made for, and names those of none', () => {
    const series = file('week.json', JSON.stringify({ format: 'parcours-series', version: 1, tasks: [{ course: 'closed-line' }, { course: 'slalom' }] })); // prettier-ignore
    const mine = (course: string): string => projectToText({ ...readyProject(course)!, files: [{ name: 'main.py', text: NOTHING }] }); // prettier-ignore
    const all = handIns('week', {
      ...{ 'ada.json': mine('closed-line'), 'ben.json': mine('slalom'), 'cleo.json': mine('closed-line') },
      'dora.py': NOTHING,
    });
    const { out } = classAct('add', join(folder, 'week-of-9a.json'), series, all, '--json');
    const found = JSON.parse(out) as { pupils: { name: string; tasks: { state: string }[] }[] };
    expect(found.pupils.map(({ name, tasks }) => [name, ...tasks.map(({ state }) => state)])).toEqual([
      ['ada', 'failed', 'missing'],
      ['cleo', 'failed', 'missing'],
      ['ben', 'missing', 'failed'],
    ]);
    expect(classAct('add', join(folder, 'week-of-9a.json'), series, all).out).toContain(
      'For no task of the series: dora',
    );
  });

  it('refuses what it cannot read or write, names it, and leaves the file as it was', () => {
    const broken = file('broken.json', '{"format": "parcours-class", "version": 9}');
    expect(classAct('report', broken)).toMatchObject({
      code: 2,
      err: `parcours: ${broken}: Class version 9 is newer than this app (2). Update Parcours.\n`,
    });
    expect(classAct('add', broken, 'closed-line', folder).code).toBe(2);
    expect(readFileSync(broken, 'utf8')).toBe('{"format": "parcours-class", "version": 9}');
    expect(classAct('report', join(folder, 'nobody.json')).err).toContain('nobody.json');
    const nowhere = join(folder, 'no', '9a.json');
    expect(classAct('set', nowhere, '--name', '9a').code).toBe(2);
    expect(existsSync(nowhere)).toBe(false);
    expect(classAct('set', join(folder, 'new.json'), '--names', file('empty.txt', '1\n2\n')).err).toContain('there are no names in it'); // prettier-ignore
  });
});

describe('the words behind parcours class', () => {
  const read = (...words: readonly string[]): object => {
    const asked = parseCommand(['class', ...words], { variables: {}, today: '2026-11-30' });
    return asked.type === 'bad' ? { problem: asked.problem } : 'options' in asked ? asked.options : asked;
  };

  it.each([
    [[], 'class: which of its commands? class add, class set, class merge, class report'],
    [['repport', '8b.json'], 'Unknown command "class repport". Did you mean class report?'],
    [['add'], 'Which class? For example: parcours class add 8b.json closed-line class/'],
    [['add', '8b.json'], 'Which task? For example: parcours class add 8b.json closed-line class/'],
    [['add', '8b.json', 'slalom'], 'Which hand-ins? For example: parcours class add 8b.json closed-line class/'],
    [['merge', '8b.json'], 'Which other copy? For example: parcours class merge 8b.json other/8b.json'],
    [['report', '8b.json', 'x'], 'One class at a time: what is "x"?'],
    [['set', '8b.json', '--csv=x'], '--csv is not for class set, but for check, sweep, tournament, class report. class set takes --name, --names, --scale, --pass, --due, --json, --quiet, --lang.'], // prettier-ignore
    [['add', '8b.json', 'a', 'b', '--date=2026-02-30'], '--date: "2026-02-30" is no day such as 2026-11-30.'],
    [['set', '8b.json', '--scale=us'], '--scale: "us" is not known. Known: ch6, de6, de15, fr20, it10.'],
    [['set', '8b.json', '--pass=0'], '--pass: "0" is neither "even" nor a whole number of per cent from 1 to 99.'],
    [['set', '8b.json', '--due=bend'], '--due: "bend" is no TASK=DAY such as bend=2026-11-30.'],
    [['report', '8b.json', '--decimals=dot'], '--decimals: "dot" is neither "point" nor "comma".'],
    [['report', '8b.json', '--decimals=point'], '--decimals: there is no table for a spreadsheet. Add --csv FILE.csv.'],
    [['add', '8b.json', 'a', 'b', '--jobs=0'], '--jobs: "0" is not a whole number from 1 to 256.'],
  ])('that are %j are told what is missing', (words, problem) => expect(read(...words)).toEqual({ problem }));

  it('give the day, the share for a pass and the last days of tasks', () => {
    expect(read('set', '8b.json', '--pass=60%', '--due=a=b=2026-12-01')).toMatchObject({
      ...{ act: 'set', file: '8b.json', day: '2026-11-30', pass: 60, due: [['a=b', '2026-12-01']] },
    });
  });
});
