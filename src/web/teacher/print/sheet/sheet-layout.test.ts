import { describe, expect, it } from 'vitest';

import type { PaperTask } from '../task/task-blocks';
import { paperQr } from './paper-qr';
import { layOutSheet, SHEET_MM, spaces, type Mark, type SheetContent, type SheetLayout } from './sheet-layout';

const noTask: PaperTask = {
  ...{ title: 'Der Slalom', text: '', picture: null, goalsTitle: 'Das ist das Ziel', goals: [], rules: [] },
  ...{ checksTitle: 'Ausserdem geprüft', checks: [], stars: [], hints: [] },
};
const task: PaperTask = {
  ...noTask,
  text: 'Fahre **los**.',
  goals: ['Erreiche das Ziel'],
  rules: ['nichts berühren'],
};
const rich: PaperTask = {
  ...task,
  text: 'Fahre **los**.\n\n- um das Tor\n- ins `Ziel`',
  checks: ['nutzt eine Schleife (2 Punkte)'],
  stars: ['geschafft', 'unter 15 s', 'unter 9 s'],
};
/** A task with a long text. */
const wordy: PaperTask = { ...rich, text: `${rich.text}\n\n${'Langsam ist auch gut. '.repeat(24)}` };
const plain: SheetContent = {
  task,
  courseMm: [1200, 900],
  qr: paperQr('https://parcours.example/#p=9.abc'),
  space: 'some',
  credit: '',
  words: {
    ...{ name: 'Name', class: 'Klasse', date: 'Datum', open: 'Aufgabe öffnen', questions: ['Mein Plan', 'Gesehen'] },
    scale: (scale) => `Massstab 1:${String(scale)}`,
  },
};
const sheet = (part: Partial<SheetContent> = {}): SheetLayout => layOutSheet({ ...plain, ...part });
const wordsOf = (marks: readonly Mark[]): string[] =>
  marks.flatMap((mark) =>
    mark.kind === 'row' && mark.row.row.pieces.length > 0 ? [mark.row.row.pieces.map(({ text }) => text).join('')] : [],
  );
const allWords = ({ pages }: SheetLayout): string => pages.flatMap(wordsOf).join('\n');

/** Left, upper, right and lower edge of something on a sheet. */
function edgesOf(mark: Mark): readonly [number, number, number, number] {
  if (mark.kind === 'line') return [mark.from[0], Math.min(mark.from[1], mark.to[1]), mark.to[0], mark.to[1]];
  if (mark.kind !== 'row') return [mark.at[0], mark.at[1], mark.at[0] + mark.size[0], mark.at[1] + mark.size[1]];
  const { row, topMm } = mark.row;
  const wide = Math.max(row.picture?.[0] ?? 0, ...row.pieces.map(({ xMm, widthMm }) => xMm + widthMm));
  const top = mark.at[1] + topMm;
  return [mark.at[0], top, mark.at[0] + wide, top + row.heightMm];
}
const lastOf = (layout: SheetLayout): readonly Mark[] => layout.pages.at(-1)!;
const writing = (marks: readonly Mark[]): Mark[] => marks.filter((mark) => mark.kind === 'line' && !mark.isStrong);

const long = Array.from(
  { length: 30 },
  (_, part) => `Absatz ${String(part)}: ${'Fahre vorsichtig weiter. '.repeat(8)}`,
);
const cases: Readonly<Record<string, Partial<SheetContent>>> = {
  'a usual task': {},
  'a task with checks and stars': { task: rich },
  'a course without a task': { task: noTask },
  'no code': { qr: null },
  'a long link': { qr: paperQr('https://parcours.example/#p=9.'.padEnd(1600, 'x')) },
  'a long text': { task: { ...task, text: long.join('\n\n') } },
  'a long title': { task: { ...task, title: 'Ein Titel mit sehr vielen Wörtern '.repeat(6) } },
  'a title in one word': { task: { ...task, title: 'Donaudampfschifffahrt'.repeat(5) } },
  'many hints': { task: { ...task, hints: long.slice(0, 9).map((text) => ({ title: 'Tipp', text })) } },
  'a high picture': { task: { ...task, picture: { data: '', format: 'PNG', size: [300, 1200] } } },
  'the smallest course': { courseMm: [200, 200] },
  'the largest course': { courseMm: [10_000, 10_000] },
  'a course like a lane': { courseMm: [10_000, 200] },
  'a course like a tower': { courseMm: [200, 10_000] },
};

describe('a worksheet', () => {
  it.each(Object.entries(cases))(
    'stays 10 mm off the edges of its paper, and nothing lies over anything: %s',
    (_, part) => {
      for (const space of spaces)
        for (const page of sheet({ ...part, space }).pages) {
          const edges = page.map((mark) => ({ mark, edges: edgesOf(mark) }));
          for (const {
            edges: [left, top, right, bottom],
          } of edges) {
            expect(left).toBeGreaterThan(10);
            expect(top).toBeGreaterThan(10);
            expect(right).toBeLessThan(SHEET_MM[0] - 10);
            expect(bottom).toBeLessThan(SHEET_MM[1] - 6);
          }
          const blocks = edges.filter(({ mark }) => mark.kind !== 'line');
          for (const [place, { edges: one, mark }] of blocks.entries())
            for (const { edges: other, mark: second } of blocks.slice(place + 1)) {
              const isApart = one[2] <= other[0] + 0.01 || other[2] <= one[0] + 0.01 || one[3] <= other[1] + 0.01 || other[3] <= one[1] + 0.01; // prettier-ignore
              // The code's white rim may lie below rows beside it.
              expect(isApart || [mark.kind, second.kind].includes('qr'), `${mark.kind} over ${second.kind}`).toBe(true);
            }
        }
    },
  );

  it('sets nothing smaller than 9 pt', () => {
    for (const part of Object.values(cases))
      for (const mark of sheet(part).pages.flat())
        if (mark.kind === 'row' && mark.row.row.picture === null)
          expect((mark.row.row.sizeMm * 72) / 25.4).toBeGreaterThanOrEqual(9);
  });

  it('has on one page title, name, task, course, scale and questions, in this order', () => {
    const { pages, course } = sheet();
    expect(pages).toHaveLength(1);
    expect(wordsOf(pages[0]!)).toEqual([
      ...['Der Slalom', 'Aufgabe öffnen', 'Name', 'Klasse', 'Datum', 'Fahre los.'],
      ...['Das ist das Ziel', 'Erreiche das Ziel', 'nichts berühren'],
      ...['20 cm', `Massstab 1:${String(course.scale)}`, 'Mein Plan', 'Gesehen'],
    ]);
  });

  it('is one sheet for a task of a few lines, with a smaller course', () => {
    const { pages, course } = sheet({ task: rich });
    expect(pages).toHaveLength(1);
    expect(course.size[1]).toBeGreaterThan(40);
  });

  it('leaves the questions to a second page before the course becomes too small to see anything', () => {
    const { pages, course } = sheet({ task: wordy });
    expect(pages).toHaveLength(2);
    expect(wordsOf(pages[0]!)).toContain('nutzt eine Schleife (2 Punkte)');
    expect(pages[0]!.some(({ kind }) => kind === 'course')).toBe(true);
    expect(course.size[1]).toBeGreaterThan(70);
    expect(wordsOf(pages[1]!)).toEqual(['Mein Plan', 'Gesehen', 'Der Slalom', '2/2']);
  });

  it('says at its foot who made the task, and under which licence', () => {
    expect(wordsOf(lastOf(sheet({ credit: 'Ada Keller, CC BY 4.0' }))).at(-1)).toBe('Ada Keller, CC BY 4.0');
    const [first] = sheet({ task: wordy, credit: 'Ada Keller, CC BY 4.0' }).pages;
    expect(wordsOf(first!).slice(-2)).toEqual(['Der Slalom · Ada Keller, CC BY 4.0', '1/2']);
    expect(allWords(sheet())).not.toContain('·');
  });

  it('draws the course larger where nobody needs room to write', () => {
    expect(sheet({ space: 'none' }).course.scale).toBeLessThan(sheet().course.scale);
    expect(writing(lastOf(sheet({ space: 'none' })))).toEqual([]);
  });

  it('has three lines for each question, or as many as the page takes, or squares', () => {
    const flat = { courseMm: [2000, 600], task: noTask } as const;
    expect(writing(lastOf(sheet(flat)))).toHaveLength(6);
    expect(writing(lastOf(sheet({ ...flat, space: 'lines' })))).toHaveLength(16);
    const squares = lastOf(sheet({ ...flat, space: 'squares' })).filter(({ kind }) => kind === 'squares');
    expect(squares).toHaveLength(2);
    for (const mark of squares) expect(edgesOf(mark)[3] - edgesOf(mark)[1]).toBeGreaterThan(40);
  });

  it('goes on on further pages with a long text, of which no word is lost, each with its number', () => {
    const layout = sheet(cases['a long text']);
    expect(layout.pages.length).toBeGreaterThan(2);
    const said = allWords(layout).replace(/\s+/g, ' ');
    for (const paragraph of long) expect(said.replace(/ \d\/\d/g, '')).toContain(paragraph.slice(0, 60).trim());
    layout.pages.forEach((page, index) =>
      expect(wordsOf(page).at(-1)).toBe(`${String(index + 1)}/${String(layout.pages.length)}`),
    );
    expect(lastOf(layout).some(({ kind }) => kind === 'course')).toBe(true);
  });

  it('has one code and one drawing, however many pages', () => {
    const marks = sheet(cases['a long text']).pages.flat();
    expect(['course', 'qr'].map((kind) => marks.filter((mark) => mark.kind === kind).length)).toEqual([1, 1]);
    expect(sheet({ qr: null }).pages.flat().some(({ kind }) => kind === 'qr')).toBe(false); // prettier-ignore
  });

  it('keeps the drawing of a usual course at least 50 mm high, or takes a page of its own for it', () => {
    for (const paragraphs of [4, 5, 6, 7, 8, 9, 10]) {
      const text = long.slice(0, paragraphs).join('\n\n');
      expect(sheet({ task: { ...task, text } }).course.size[1]).toBeGreaterThanOrEqual(50);
    }
  });
});
