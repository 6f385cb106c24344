import type { Point } from '#scene/scene';

import type { Line, Span } from '../../../session/task/markup';
import { emsOf } from './letter-widths';

/** Sign before the first row of a paragraph: a list mark, a ring to tick off, or a number of stars. */
export type Sign = { readonly kind: 'mark'; readonly text: string } | { readonly kind: 'ring' } | Stars;
interface Stars {
  readonly kind: 'stars';
  readonly count: number;
}

/** A paragraph, each of whose lines begins a row. */
export interface Paragraph {
  readonly kind: 'words';
  readonly lines: readonly Line[];
  readonly sizeMm: number;
  readonly indentMm: number;
  /** Stands in the indent. */
  readonly sign: Sign | null;
  /** Room above it, except at the top of a page. */
  readonly aboveMm: number;
  /** A heading does not stay alone at the foot of a page. */
  readonly staysWithNext: boolean;
}

/** A picture on its own. */
export interface PaperPicture {
  readonly kind: 'picture';
  readonly size: Point;
  readonly aboveMm: number;
}
export type PaperBlock = Paragraph | PaperPicture;

/** A part of a row that looks the same, from `xMm` on. */
export interface Piece {
  readonly kind: Span['kind'];
  readonly text: string;
  readonly xMm: number;
  readonly widthMm: number;
}

/** A row of words, or a picture. */
export interface Row {
  readonly pieces: readonly Piece[];
  readonly picture: Point | null;
  readonly sizeMm: number;
  readonly heightMm: number;
  readonly aboveMm: number;
  readonly sign: Sign | null;
  /** Stays on the page of the next row. */
  readonly isTied: boolean;
}

/** A row and where it is on its page. */
export interface PlacedRow {
  readonly row: Row;
  readonly topMm: number;
}

/** From row to row, in parts of the type size. */
export const LEADING = 1.4;

/** Base line of a row, in type sizes from its top. */
export const BASE = (LEADING - 1) / 2 + 0.8;

/** Sets blocks in rows of this width. */
export const setRows = (blocks: readonly PaperBlock[], widthMm: number): readonly Row[] =>
  blocks.flatMap((block) => (block.kind === 'words' ? rowsOf(block, widthMm) : [pictureRow(block)]));

const pictureRow = ({ size, aboveMm }: PaperPicture): Row => ({
  ...{ pieces: [], picture: size, sizeMm: 0, heightMm: size[1], aboveMm, sign: null, isTied: false },
});

function rowsOf({ lines, sizeMm, indentMm, sign, aboveMm, staysWithNext }: Paragraph, widthMm: number): Row[] {
  const set = lines.flatMap((line) => setLine(line, widthMm - indentMm, sizeMm));
  return set.map((pieces, index) => ({
    pieces: pieces.map((piece) => ({ ...piece, xMm: piece.xMm + indentMm })),
    picture: null,
    sizeMm,
    heightMm: LEADING * sizeMm,
    aboveMm: index === 0 ? aboveMm : 0,
    sign: index === 0 ? sign : null,
    // Two rows of a paragraph stay together at the foot and at the head of a page.
    isTied: index === set.length - 1 ? staysWithNext : index === 0 || index === set.length - 2,
  }));
}

/** A part of a word, and which part of the line it comes from. */
interface Part extends Span {
  readonly span: number;
}

/** A space between two parts. */
const SPACE: Part = { kind: 'text', text: ' ', span: -1 };

/** The words of a line; where bold or code ends within a word, it has several parts. No-break spaces part no words. */
function wordsOf(line: Line): readonly (readonly Part[])[] {
  const words: Part[][] = [];
  let isNew = true;
  line.forEach(({ kind, text }, span) => {
    for (const part of text.split(/([ \t]+)/)) {
      if (part === '') continue;
      const isSpace = /^[ \t]/.test(part);
      if (!isSpace && isNew) words.push([]);
      if (!isSpace) words.at(-1)?.push({ kind, text: part, span });
      isNew = isSpace;
    }
  });
  return words;
}

/** Sets a line in as many rows as it needs. A word that is wider than a row goes on in the next. */
function setLine(line: Line, roomMm: number, sizeMm: number): readonly (readonly Piece[])[] {
  const width = (text: string, kind: Span['kind']): number => emsOf(text, kind) * sizeMm;
  const rows: (Part & Piece)[][] = [[]];
  let end = 0;
  const put = ({ kind, text, span }: Part): void => {
    const row = rows.at(-1) ?? [];
    const last = row.at(-1);
    const isSame = last?.span === span;
    if (isSame) row.pop();
    const xMm = isSame ? last.xMm : end;
    const whole = isSame ? last.text + text : text;
    const widthMm = width(whole, kind);
    row.push({ kind, text: whole, span, xMm, widthMm });
    end = xMm + widthMm;
  };
  const newRow = (): void => {
    rows.push([]);
    end = 0;
  };
  for (const word of wordsOf(line)) {
    const wide = word.reduce((sum, { text, kind }) => sum + width(text, kind), 0);
    const last = rows.at(-1)?.at(-1);
    if (last !== undefined && end + width(' ', 'text') + wide > roomMm) newRow();
    // The space belongs to code or bold that goes on behind it.
    else if (last !== undefined) put(last.span === word[0]?.span ? { ...last, text: ' ' } : SPACE);
    for (const part of word)
      for (const text of cut(part, roomMm, () => end, width)) {
        if (end > 0 && end + width(text, part.kind) > roomMm) newRow();
        put({ ...part, text });
      }
  }
  return rows;
}

/** A part in one piece if a row can hold it, otherwise letter by letter. */
function* cut(
  { text, kind }: Part,
  roomMm: number,
  endMm: () => number,
  width: (text: string, kind: Span['kind']) => number,
): Iterable<string> {
  if (endMm() + width(text, kind) <= roomMm) yield text;
  else yield* text;
}

/**
 * Spreads rows over pages of this height: what is tied stays together where a page can hold it.
 *
 * @param usedMm how much of the first page is taken, from its top
 */
export function breakPages(rows: readonly Row[], heightMm: number, usedMm = 0): readonly (readonly PlacedRow[])[] {
  const pages: PlacedRow[][] = [[]];
  let end = usedMm;
  const isTop = (): boolean => end === 0 && pages.at(-1)?.length === 0;
  const heightOf = (some: readonly Row[]): number => some.reduce((sum, row) => sum + row.aboveMm + row.heightMm, 0);
  const place = (row: Row, needed: number): void => {
    if (!isTop() && end + needed > heightMm) {
      pages.push([]);
      end = 0;
    }
    const topMm = isTop() ? 0 : end + row.aboveMm;
    pages.at(-1)?.push({ row, topMm });
    end = topMm + row.heightMm;
  };
  for (const group of groupsOf(rows))
    group.forEach((row, index) => place(row, index === 0 ? Math.min(heightMm, heightOf(group)) : heightOf([row])));
  return pages;
}

/** Rows that stay together. */
function groupsOf(rows: readonly Row[]): readonly (readonly Row[])[] {
  const groups: Row[][] = [];
  rows.forEach((row, index) => {
    if (rows[index - 1]?.isTied === true) groups.at(-1)?.push(row);
    else groups.push([row]);
  });
  return groups;
}
