import { describe, expect, it } from 'vitest';

import { unreadable } from '../result';
import { ahead, checked, sceneWith, targetAt, taskWith } from '../testing/tasks';
import { classResult } from './class-result';
import { htmlOf } from './html';
import { tableOf } from './table';

/** A task with half points, of which the second check asks for a loop. */
const task = taskWith(sceneWith([targetAt(600, 450)]), {
  checks: [
    { type: 'goals', points: 1.5 },
    { type: 'loop', points: 2.5, needed: false },
  ],
  stars: [2, 4],
});
const rows = async () => [
  { name: 'Weiss Tim_10231_assignsubmission_file_', result: unreadable(task.checks, { code: 'zip', params: {} }) },
  { name: 'Bonnet', result: await checked(task, 'x = 1\n'), note: '=1+1; "gut"' },
  { name: 'Bérard', result: await checked(task, ahead(3000)) },
];

/** The cells of a table, read as a spreadsheet does that takes this sign for the next column. */
function cellsOf(text: string, sign: string): readonly (readonly string[])[] {
  const cell = new RegExp(`("(?:[^"]|"")*"|[^${sign}\\r]*)(${sign}|\\r\\n)`, 'g');
  const all: string[][] = [[]];
  for (const [, value = '', end] of text.replace('\ufeff', '').matchAll(cell)) {
    all.at(-1)?.push(value.replace(/^"|"$/g, '').replaceAll('""', '"'));
    if (end !== sign) all.push([]);
  }
  return all.slice(0, -1);
}

describe('the table of a class for a spreadsheet', () => {
  it('says in German words what is checked, with a comma in its numbers and a semicolon between cells', async () => {
    const text = tableOf(classResult('t', await rows(), 'de'), task, 'de');
    expect(text.startsWith('\ufeffName;Ergebnis;Punkte;von;Sterne;')).toBe(true);
    const [head, berard, bonnet, weiss] = cellsOf(text, ';');
    expect(head?.slice(5)).toEqual(['Ziel des Parcours', 'benutzt eine Schleife', 'Welt 1', 'Welt 1: Zeit in s', 'Welt 1: Berührungen', 'Bemerkungen', 'Notiz']); // prettier-ignore
    expect(berard?.slice(0, 8)).toEqual(['Bérard', 'bestanden', '1,5', '4', '1', 'bestanden', 'Das Programm hat keine Schleife.', 'bestanden']); // prettier-ignore
    expect(berard?.[8]).toMatch(/^\d+,\d{1,2}$/);
    expect(bonnet).toEqual(['Bonnet', 'nicht bestanden', '0', '4', '0', 'Der Roboter hat sich nie bewegt.', 'Das Programm hat keine Schleife.', 'Der Roboter hat sich nie bewegt.', '', '0', '', `'=1+1; "gut"`]); // prettier-ignore
    expect(weiss?.slice(0, 10)).toEqual(['Weiss Tim', 'nicht lesbar', '', '', '', '', '', '', '', '']);
    expect(weiss?.[10]).toBe('Das ist keine Zip-Datei, oder nur ein Teil davon.'); // its result says that it cannot be read
  });

  it('has points set by hand in the place of those of the checks, and says which they are', async () => {
    const marked = (await rows()).map((one) => (one.name === 'Bonnet' ? { ...one, marked: 2.5 } : one));
    const found = classResult('t', marked, 'de');
    const [head, berard, bonnet, weiss] = cellsOf(tableOf(found, task, 'de'), ';');
    expect(head?.slice(2, 6)).toEqual(['Punkte', 'von', 'von Hand gesetzt', 'Sterne']);
    expect(berard?.slice(2, 5)).toEqual(['1,5', '4', '']);
    expect(bonnet?.slice(2, 5)).toEqual(['2,5', '4', 'ja']);
    expect(weiss?.length).toBe(head?.length);
    expect(htmlOf(found, task, 'de')).toContain(
      'Punkte: 2.5 <span title="von Hand gesetzt">✎</span> (von Hand gesetzt)',
    );
    // A code stands below the note of those who have one.
    expect(htmlOf(found, task, 'de', { codeOf: ({ name }) => (name === 'Bonnet' ? '<svg id="code"/>' : '') })).toMatch(/class="note">=1\+1.*\n.*<svg id="code"\/><span>Das führt zu deinem Programm/); // prettier-ignore
  });

  it('has grades beside the points where the class has a scale, as the report does, and none for what was not read', async () => {
    const found = classResult('t', await rows(), 'de');
    const [head, berard, , weiss] = cellsOf(tableOf(found, task, 'de', { gradeOf: () => 4.5 }), ';');
    expect([head, berard, weiss].map((cells) => cells?.slice(2, 5))).toEqual([
      ['Punkte', 'von', 'Note'],
      ['1,5', '4', '4,5'],
      ['', '', ''],
    ]);
    const [named] = cellsOf(tableOf(found, task, 'de', { gradeOf: () => 4.5, className: '8b' }), ';');
    expect(named?.[4]).toBe('Note (8b)');
    const gradeOf = ({ name }: { readonly name: string }): string => (name === 'Bérard' ? '4.5' : '1.0');
    const report = htmlOf(found, task, 'de', { gradeOf, className: '8b' });
    expect(report).toContain('Noten nach der Skala von «8b»');
    expect(htmlOf(found, task, 'de', { className: '8b' })).not.toContain('Skala');
    expect(report).toContain('<td class="number grade" data-of="Note">4.5</td>');
    expect(report.match(/ · Note: /g)).toHaveLength(2);
  });

  it('brings the link to each note, beside it', async () => {
    const found = classResult('t', await rows(), 'de');
    const linkOf = ({ name }: { readonly name: string }): string => `https://school.example/#${name}`;
    const [head, berard, bonnet, weiss] = cellsOf(tableOf(found, task, 'de', { linkOf }), ';');
    expect(head?.slice(-2)).toEqual(['Notiz', 'Link zur Rückmeldung']);
    expect(bonnet?.slice(-2)).toEqual([`'=1+1; "gut"`, 'https://school.example/#Bonnet']);
    expect([berard, weiss].map((one) => [one?.length, one?.at(-1)])).toEqual([[head?.length, ''], [head?.length, '']]); // prettier-ignore
  });

  it('has the same cells in every language, in English between commas', async () => {
    const of = async (language: 'fr' | 'it' | 'en') =>
      tableOf(classResult('t', await rows(), language), task, language);
    for (const [text, sign] of [
      [await of('fr'), ';'],
      [await of('it'), ';'],
      [await of('en'), ','],
    ] as const)
      expect(cellsOf(text, sign).map(({ length }) => length)).toEqual([12, 12, 12, 12]);
    expect(cellsOf(await of('en'), ',')[1]?.slice(0, 4)).toEqual(['Bérard', 'passed', '1.5', '4']);
  });
});
