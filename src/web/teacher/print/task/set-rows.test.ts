import { describe, expect, it } from 'vitest';

import { spansOf } from '../../../session/task/markup';
import { emsOf } from './letter-widths';
import { breakPages, setRows, type PaperBlock, type Paragraph, type Row } from './set-rows';

/** A paragraph in type 10 mm high: most letters are 5.56 mm wide, spaces 2.78 mm. */
const words = (text: string, part: Partial<Paragraph> = {}): Paragraph => ({
  ...{ kind: 'words', lines: [spansOf(text)], sizeMm: 10, indentMm: 0, sign: null, aboveMm: 0, staysWithNext: false },
  ...part,
});
const textOf = ({ pieces }: Row): string => pieces.map(({ text }) => text).join('');
const texts = (block: PaperBlock, widthMm: number): string[] => setRows([block], widthMm).map(textOf);

describe('words in rows', () => {
  it('break where the next word would leave the row', () => {
    expect(texts(words('aaa bbb eee'), 36.2)).toEqual(['aaa bbb', 'eee']);
    expect(texts(words('aaa bbb eee'), 36.1)).toEqual(['aaa', 'bbb', 'eee']);
  });

  it('have one space between them, however many were typed', () => {
    expect(texts(words('aaa   bbb '), 100)).toEqual(['aaa bbb']);
  });

  it('stay together at a no-break space, as between a number and its unit', () => {
    expect(texts(words('aaa 10\u00a0cm'), 36)).toEqual(['aaa', '10\u00a0cm']);
    expect(texts(words('aaa 10 cm'), 36)).toEqual(['aaa 10', 'cm']);
  });

  it('begin a new row with each line of their paragraph', () => {
    expect(texts(words('', { lines: [spansOf('eins'), spansOf('zwei')] }), 100)).toEqual(['eins', 'zwei']);
  });

  it('go on in the next row in the middle of a word that no row holds', () => {
    expect(texts(words('x aaaaaaaa b'), 23)).toEqual(['x', 'aaaa', 'aaaa', 'b']);
  });

  it('do not break where bold ends within a word', () => {
    expect(texts(words('aaa **Links**kurve'), 60)).toEqual(['aaa', 'Linkskurve']);
  });

  it('have a piece for each look, one behind the other', () => {
    const [row] = setRows([words('ab **cd ef** `g(1, 2)` h')], 200);
    expect(row?.pieces.map(({ kind, text }) => [kind, text])).toEqual([
      ['text', 'ab'],
      ['text', ' '],
      ['bold', 'cd ef'],
      ['text', ' '],
      ['code', 'g(1, 2)'],
      ['text', ' '],
      ['text', 'h'],
    ]);
    row?.pieces.forEach(({ xMm }, index) => {
      const before = row.pieces[index - 1];
      expect(xMm).toBeCloseTo(before === undefined ? 0 : before.xMm + before.widthMm);
    });
  });

  it('never reach over the edge of their row', () => {
    const text =
      'Fahre **so schnell** wie `möglich(100, 200)` durch das Labyrinth-Labyrinth, ohne **etwas** zu berühren. ';
    for (let widthMm = 25; widthMm < 400; widthMm += 7)
      for (const { pieces } of setRows([words(text.repeat(3), { indentMm: 5 })], widthMm)) {
        const last = pieces.at(-1)!;
        expect(pieces[0]!.xMm).toBe(5);
        expect(last.xMm + last.widthMm).toBeLessThanOrEqual(widthMm);
      }
  });

  it('have the widths of Helvetica, accents and capitals with them', () => {
    // Adobe's font metrics: Z 611, ü 556, r 333, i 222, c 500, h 556.
    expect(emsOf('Zürich', 'text')).toBeCloseTo(2.778);
    expect(emsOf('œ…', 'text')).toBeCloseTo(1.944);
    expect(emsOf('iii', 'code')).toBe(emsOf('mmm', 'code'));
  });

  it('have their sign before the first row alone', () => {
    const rows = setRows([words('aaa bbb', { sign: { kind: 'mark', text: '•' }, aboveMm: 4 })], 20);
    expect(rows.map(({ sign, aboveMm }) => [sign, aboveMm])).toEqual([
      [{ kind: 'mark', text: '•' }, 4],
      [null, 0],
    ]);
  });
});

describe('rows on pages', () => {
  const row = (name: string, part: Partial<Row> = {}): Row => ({
    pieces: [{ kind: 'text', text: name, xMm: 0, widthMm: 5 }],
    ...{ picture: null, sizeMm: 7, heightMm: 10, aboveMm: 0, sign: null, isTied: false },
    ...part,
  });
  const pages = (rows: readonly Row[], heightMm: number): string[] =>
    breakPages(rows, heightMm).map((page) => page.map((one) => `${textOf(one.row)}${String(one.topMm)}`).join(' '));

  it('follow each other with the room above them, none at the top of a page', () => {
    const rows = ['a', 'b', 'c', 'd'].map((name) => row(name, { aboveMm: 5 }));
    expect(pages(rows, 39)).toEqual(['a0 b15', 'c0 d15']);
  });

  it('go to the next page with what they are tied to', () => {
    expect(pages([row('a'), row('b'), row('head', { isTied: true }), row('c')], 30)).toEqual(['a0 b10', 'head0 c10']);
  });

  it('break where they are tied if no page can hold them', () => {
    expect(pages([row('a', { isTied: true }), row('b', { isTied: true }), row('c')], 20)).toEqual(['a0 b10', 'c0']);
  });

  it('keep two rows of a paragraph on either page', () => {
    const paragraph = setRows([words('aaaa bbbb cccc dddd')], 25);
    expect(paragraph.map(({ isTied }) => isTied)).toEqual([true, false, true, false]);
    expect(pages([row('z'), ...paragraph], 10 + 3 * 14)).toEqual(['z0 aaaa10 bbbb24', 'cccc0 dddd14']);
  });
});
