import { bytesOf, glyphOf } from './glyph';

/** Pictures that follow each other on the display. */
export interface Film {
  readonly length: number;
  /** Picture number `place` (from 0): 25 brightnesses 0 … 9, row by row. */
  frameAt(place: number): Uint8Array;
}

/** Five pixels from top to bottom. */
type Column = readonly number[];

const SIDE = 5;
const BLANK_COLUMN: Column = [0, 0, 0, 0, 0];

/**
 * A text that scrolls through the display: one picture for each column that enters from the right, the last blank.
 *
 * Proportional: letters as wide as they are (three columns at least, counted from the first), without a blank first
 * column, except for the first letter of the text, which has it. Source: micropython-microbit-v2 microbit_image.c, the
 * scrolling string iterator.
 */
export function scrollFilm(text: string, monospace: boolean): Film {
  const columns = columnsOf(text, monospace);
  return {
    length: columns.length,
    frameAt(place) {
      const frame = new Uint8Array(SIDE * SIDE);
      for (let x = 0; x < SIDE; x++) {
        const column = columns[place - SIDE + 1 + x] ?? BLANK_COLUMN;
        column.forEach((value, y) => (frame[y * SIDE + x] = value));
      }
      return frame;
    },
  };
}

/** The columns of a text as it runs through the display, including the five blank ones behind it. */
function columnsOf(text: string, monospace: boolean): Column[] {
  const columns: Column[] = [];
  const glyphs = new Map<string, readonly Column[]>();
  for (const char of bytesOf(text)) {
    const glyph = glyphs.get(char) ?? glyphColumns(char);
    glyphs.set(char, glyph);
    const first = monospace || columns.length === 0 || isLit(glyph[0]) ? 0 : 1;
    if (columns.length > 0) columns.push(BLANK_COLUMN);
    columns.push(...glyph.slice(first, monospace ? SIDE : widthOf(glyph)));
  }
  for (let i = 0; i < SIDE; i++) columns.push(BLANK_COLUMN);
  return columns;
}

function glyphColumns(char: string): Column[] {
  const glyph = glyphOf(char);
  return Array.from({ length: SIDE }, (_, x) => Array.from({ length: SIDE }, (_, y) => glyph[y * SIDE + x] ?? 0));
}

function widthOf(glyph: readonly Column[]): number {
  if (isLit(glyph[4])) return 5;
  return isLit(glyph[3]) ? 4 : 3;
}

const isLit = (column: Column | undefined): boolean => column?.some((value) => value > 0) ?? false;
