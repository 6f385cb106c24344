import { describe, expect, it } from 'vitest';
import { LANGUAGES } from '#core/languages';
import { reasonCodes, remarkCodes, unreadable } from '../result';
import { ahead, checked, sceneWith, targetAt, taskWith } from '../testing/tasks';
import { classResult, type NamedResult } from './class-result';
import { htmlOf } from './html';
import { reasonText, remarkText } from './say';
import { csvOf, jsonOf, junitOf } from './texts';

/** Checks that each tag is closed. */
function wellFormed(xml: string): string {
  const open: string[] = [];
  for (const [, end, name = '', alone] of xml.matchAll(/<(\/?)([a-z]+)[^>]*?(\/?)>/g)) {
    if (end) expect(open.pop()).toBe(name);
    else if (!alone) open.push(name);
  }
  expect(open).toEqual([]);
  return xml;
}

const task = taskWith(sceneWith([targetAt(600, 450)]));

/** Three results: of a program that arrives, of one that does not, of something other than a program. */
async function results(): Promise<readonly NamedResult[]> {
  return [
    { name: 'Anna', result: await checked(task, ahead(3000)) },
    { name: '=Ben "<b>"', result: await checked(task, 'x = 1\n') },
    { name: 'Cem', result: unreadable(task.checks, { code: 'zip', params: {} }) },
  ];
}

describe('the result of a class', () => {
  it('tells who has the same program, but not of programs that cannot be read', async () => {
    const [anna, , cem] = (await results()) as [NamedResult, NamedResult, NamedResult];
    const found = classResult('t', [anna, { ...anna, name: 'Berta' }, cem, { ...cem, name: 'Eli' }], 'en');
    const remarks = found.handIns.map(({ result }) => result.remarks.map((one) => remarkText(one, 'en')));
    expect(remarks[0]).toEqual(['Same program as: Berta']);
    expect(remarks[1]).toEqual(['Same program as: Anna']);
    expect(remarks[2]).toEqual(['cannot be read: this is not a zip, or only a part of one.']);
  });

  it('is one sheet for a single hand-in, a table and a sheet each for several', async () => {
    const all = await results();
    const tables = [all, all.slice(0, 1)].map((some) => htmlOf(classResult('t', some, 'en'), task, 'en'));
    expect(tables.map((html) => [html.split('<table>').length - 1, html.split('<section').length - 1])).toEqual([[1, 3], [0, 1]]); // prettier-ignore
  });

  it('is the table alone where no sheets are wanted, and leads to none', async () => {
    const all = await results();
    const html = htmlOf(classResult('t', all, 'en'), task, 'en', { isTable: true });
    expect([html.includes('<table>'), html.includes('hand-in-'), html.includes('<section')]).toEqual([
      true,
      false,
      false,
    ]);
    expect(htmlOf(classResult('t', all.slice(0, 1), 'en'), task, 'en', { isTable: true })).toContain('<table>');
  });

  it('says once of each hand-in in its table and on its sheet that it cannot be read, and why', async () => {
    const html = htmlOf(classResult('t', await results(), 'en'), task, 'en');
    expect(html.split(/cannot be read/i)).toHaveLength(3);
    expect(html.split('This is not a zip, or only a part of one.')).toHaveLength(3);
  });

  it('is a line of JSON without the time of this computer', async () => {
    const found = classResult('t', await results(), 'en');
    expect(JSON.parse(jsonOf(found, task, 'en'))).toMatchObject({
      task: 't',
      maxPoints: 1,
      passed: 1,
      of: 3,
      handIns: [
        { passed: false, worlds: [{ passed: false, reason: 'The robot never moved.', atMs: null }] },
        {
          name: 'Anna',
          passed: true,
          points: 1,
          worlds: [{ id: 'visible', hidden: false, reason: null, touches: 0 }],
          remarks: [],
        },
        {
          name: 'Cem',
          passed: false,
          worlds: [],
          remarks: ['cannot be read: this is not a zip, or only a part of one.'],
        },
      ],
    });
  });

  it('is a table in which no name becomes a formula', async () => {
    const [head, ...rows] = csvOf(classResult('t', await results(), 'en'), 'de').split('\r\n');
    expect(head).toBe('Name,bestanden,Punkte,Sterne,goals,visible: bestanden,visible: ms,visible: Berührungen,nicht bestanden,Bemerkungen'); // prettier-ignore
    expect(rows[1]).toMatch(/^Anna,1,1,,1,1,\d+(\.\d+)?,0,,$/);
    expect(rows[0]).toBe(`"'=Ben ""<b>""",0,0,,0,0,,0,Der Roboter hat sich nie bewegt.,`);
  });

  it('is a table in which nothing that could not be read has a figure', async () => {
    const row = csvOf(classResult('t', await results(), 'en'), 'en').split('\r\n')[3];
    expect(row).toBe('Cem,,,,,,,,,"cannot be read: this is not a zip, or only a part of one."');
  });

  it('is a table in which no part of a name becomes a formula, steers a terminal or is hidden', async () => {
    const [anna] = (await results()) as [NamedResult];
    const names = ['a;=1+1', 'b\t+2', 'c\n@x', 'd; "-2', '＝1', '-3', 'e;f', 'g\u001b[2J\0', 'h\u202e', '\t=i'];
    const all = names.map((name) => ({ ...anna, name }));
    const csv = csvOf(classResult('t', all, 'en'), 'en');
    const shown = [
      ...[`"a;'=1+1"`, `"b\t'+2"`, `"c\n'@x"`, `"d;' ""-2"`, "'＝1", '-3', '"e;f"'],
      ...['g⟨U+001B⟩[2J⟨U+0000⟩', 'h⟨U+202E⟩', `"\t'=i"`],
    ];
    for (const one of shown) expect(csv).toContain(`\r\n${one},1,`);
    const html = htmlOf(classResult('t', all, 'en'), task, 'en');
    const xml = junitOf(classResult('t', all, 'en'), 'en');
    for (const text of [html, xml]) {
      expect(text).toContain('h⟨U+202E⟩');
      expect(text).not.toMatch(/[\u202e\u001b\0]/);
    }
  });

  it('is XML in which what cannot be read is an error, and what has not passed a failure', async () => {
    const xml = wellFormed(junitOf(classResult('t <1>', await results(), 'en'), 'en'));
    expect(xml).toContain('tests="3" failures="1" errors="1"');
    expect(xml).toContain('name="=Ben &quot;&lt;b&gt;&quot;"');
    expect(xml).toContain('<error message="cannot be read: this is not a zip, or only a part of one.">');
  });

  it('is a page that needs nothing else, with the ways drawn and no tags from names', async () => {
    const html = htmlOf(classResult('t', await results(), 'de'), task, 'de');
    expect(html).not.toMatch(/<script|src=|href="http|<b>"/);
    expect(html).toContain('1 von 3 bestanden');
    expect(html.match(/<section /g)).toHaveLength(3);
    expect(html).toContain('✓</b> Ziel des Parcours</li>');
    expect(html).toContain('Welt 1');
    expect(html.match(/stroke="#1e66d0"/g)?.length).toBeGreaterThan(1);
  });

  it('says of each figure what it is, for a phone, where the row of headings has no room', async () => {
    const html = htmlOf(classResult('t', await results(), 'de'), task, 'de');
    for (const name of ['Punkte', 'Zeit', 'Berührungen'])
      expect([name, html.split(`data-of="${name}"`).length]).toEqual([name, 4]);
  });
});

describe('what a check asks', () => {
  it('is told in words, a picture of the display is drawn', async () => {
    const checks = [
      { type: 'display', image: '90009:00000:00000:00000:00000' },
      { type: 'touches', most: 0 },
    ];
    const asked = taskWith(sceneWith([]), { checks });
    const html = htmlOf(classResult('t', [{ name: 'A', result: await checked(asked, 'x = 1\n') }], 'de'), asked, 'de');
    expect(html).toMatch(/Bild auf der Anzeige <svg class="leds"/);
    expect(html.match(/#ff6a58/g)).toHaveLength(2);
    expect(html).toContain('keine Berührung');
    expect(html).toContain('Das verlangte Bild war nie auf der Anzeige.');
  });
});

describe('sentences', () => {
  it('are there for every reason and every remark, in every language', () => {
    for (const language of LANGUAGES) {
      for (const code of reasonCodes) expect(reasonText({ code, params: {} }, language)).not.toBe('');
      for (const code of remarkCodes) expect(remarkText({ code, params: {} }, language)).not.toBe('');
    }
  });

  it('name the place and the value', () => {
    const reason = { code: 'delay', params: { line: 7, found: 5000, most: 2000 } } as const;
    expect(reasonText(reason, 'de')).toBe('Zeile 7: eine Pause von 5000 ms, erlaubt sind 2000 ms.');
  });
});
