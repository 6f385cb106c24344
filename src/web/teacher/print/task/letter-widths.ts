import type { Span } from '../../../session/task/markup';

/**
 * Widths of letters in thousandths of the type size, from Adobe's font metrics of Helvetica and Helvetica-Bold. Every PDF
 * reader has these fonts or one of the same widths (Arial, Liberation Sans). Letters that are not listed have `other`.
 */
const HELVETICA: Readonly<
  Record<Exclude<Span['kind'], 'code'>, readonly (readonly [width: number, letters: string])[]>
> = {
  text: [
    [191, "'"],
    [222, 'ijl‚‘’'],
    [260, '|¦'],
    [278, ' !,./:;I[\\]ft\u00a0·ÌÍÎÏìíîï'],
    [333, '()-`r„“”‹›ˆ˜¡¨²³´¸¹'],
    [350, '•'],
    [368, '"°ªº*{}'],
    [469, '^'],
    [500, 'Jcksvxyzšžçýÿ'],
    [584, '+<=>~±¬×÷µ'],
    [611, 'FTZŽ¿ßø'],
    [667, '&ABEKPSVXYŠŸÀÁÂÃÄÅÈÉÊËÝÞ'],
    [722, 'CDHNRUwÇÐÑÙÚÛÜ'],
    [778, 'GOQ©®ÒÓÔÕÖØ'],
    [834, 'Mm¼½¾'],
    [944, '%Wœæ'],
    [1000, '…‰Œ—™Æ'],
    [1015, '@'],
  ],
  bold: [
    [238, "'"],
    [278, ' ,./I\\ijl|¦‚‘’\u00a0·ÌÍÎÏìíîï'],
    [333, '!()-:;[]`ft‹›ˆ˜¡¨²³´¸¹'],
    [389, '*r{}•°ªº'],
    [500, '"z„“”ž'],
    [584, '+<=>^~±¬×÷µ'],
    [611, '?FLTZbdghnopquŽ¿ßðñòóôõöøùúûüþ'],
    [667, 'EPSVXYŠŸÈÉÊËÝÞ'],
    [722, '&ABCDHKNRUÀÁÂÃÄÅÇÐÑÙÚÛÜ'],
    [778, 'GOQw©®ÒÓÔÕÖØ'],
    [834, 'M¼½¾'],
    [944, '%mWœæ'],
    [1000, '@…‰Œ—™Æ'],
  ],
};

/** Digits, and most small letters; in bold somewhat less than most. */
const OTHER = 556;

/** A sign of no Western alphabet, an emoji for instance, is about as wide as it is high. */
const FOREIGN = 1000;

/** Courier, and every font like it. */
const CODE = 600;

/** Code is set a little smaller, with a box around it. */
export const CODE_SCALE = 0.95;

/** Room between code and the edge of its box, in parts of the type size. */
export const CODE_RIM = 0.16;

const widths = { text: tableOf(HELVETICA.text), bold: tableOf(HELVETICA.bold) };

function tableOf(groups: readonly (readonly [number, string])[]): ReadonlyMap<string, number> {
  return new Map(groups.flatMap(([width, letters]) => Array.from(letters, (letter) => [letter, width] as const)));
}

/** Width of a text as it is set, in parts of its type size. */
export function emsOf(text: string, kind: Span['kind']): number {
  const letters = Array.from(text);
  if (kind === 'code') return (letters.length * CODE * CODE_SCALE) / 1000 + 2 * CODE_RIM;
  const widthOf = (letter: string): number => widths[kind].get(letter) ?? (letter > '\u024f' ? FOREIGN : OTHER);
  return letters.reduce((sum, letter) => sum + widthOf(letter), 0) / 1000;
}
