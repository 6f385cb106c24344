import type { Point } from '#scene/scene';

/** On what a course is printed: tiles of this size to be glued together, or one sheet. */
export const papers = ['a4-tiles', 'a3-tiles', 'a3', 'a2', 'a1', 'a0', 'exact'] as const;
export type Paper = (typeof papers)[number];

/** White margin of a sheet, in mm: most printers reach no nearer than 5 mm to the edge, and the marks need room. */
export const MARGIN_MM = 10;

/** Overlap of neighbouring tiles, in mm: there one is glued onto the other. */
export const OVERLAP_MM = 10;

/** Most sheets of one print. Chosen: no class glues more, and the file can still be opened. */
export const MOST_SHEETS = 150;

/** Longest side of a PDF page, in mm: 14,400 units of 1/72 inch (ISO 32000-1, annex C). */
export const LONGEST_MM = 5080;

/** Sides of the papers in mm, the shorter first (ISO 216). */
const SIDES = { a4: [210, 297], a3: [297, 420], a2: [420, 594], a1: [594, 841], a0: [841, 1189] } as const;

/** One sheet of the print. */
export interface Tile {
  /** Column as a letter, row from the top as a number: A1, B1, … */
  readonly name: string;
  readonly column: number;
  readonly row: number;
  /** The part of the arena that it shows: its upper left corner in world mm, and its extent. */
  readonly upperLeft: Point;
  readonly size: Point;
}

/** The layout of a course on sheets. */
export interface PrintPlan {
  /** Width and height of each sheet in mm. */
  readonly page: Point;
  readonly columns: number;
  readonly rows: number;
  /** Row by row from the upper left. */
  readonly tiles: readonly Tile[];
}

/** The reason why a course cannot be printed like this. */
export type PlanProblem =
  { readonly problem: 'too-many-sheets'; readonly sheets: number } | { readonly problem: 'too-large-for-paper' };

/**
 * Lays an arena out on sheets, true to scale: tiles upright or across, whichever needs fewer, a single sheet as the
 * arena lies.
 */
export function planPrint(size: Point, paper: Paper): PrintPlan | PlanProblem {
  switch (paper) {
    case 'a4-tiles':
      return planTiles(size, SIDES.a4);
    case 'a3-tiles':
      return planTiles(size, SIDES.a3);
    case 'exact':
      return planSheet(size, [size[0] + 2 * MARGIN_MM, size[1] + 2 * MARGIN_MM]);
    case 'a3':
    case 'a2':
    case 'a1':
    case 'a0':
      return planSheet(size, size[0] > size[1] ? [SIDES[paper][1], SIDES[paper][0]] : SIDES[paper]);
    default:
      return paper satisfies never;
  }
}

/** The smallest single sheet that an arena fits on, or `exact`, if none does. */
export const smallestSheet = (size: Point): Paper =>
  (['a3', 'a2', 'a1', 'a0'] as const).find((paper) => 'tiles' in planPrint(size, paper)) ?? 'exact';

function planSheet(size: Point, page: Point): PrintPlan | PlanProblem {
  const fits = size[0] + 2 * MARGIN_MM <= page[0] && size[1] + 2 * MARGIN_MM <= page[1];
  if (!fits || Math.max(...page) > LONGEST_MM) return { problem: 'too-large-for-paper' };
  const tile: Tile = { name: 'A1', column: 0, row: 0, upperLeft: [0, size[1]], size };
  return { page, columns: 1, rows: 1, tiles: [tile] };
}

function planTiles(size: Point, [short, long]: Point): PrintPlan | PlanProblem {
  const [upright, across] = [grid(size, [short, long]), grid(size, [long, short])];
  const { page, columns, rows } = across.columns * across.rows < upright.columns * upright.rows ? across : upright;
  if (columns * rows > MOST_SHEETS) return { problem: 'too-many-sheets', sheets: columns * rows };
  const tiles: Tile[] = [];
  for (let row = 0; row < rows; row += 1)
    for (let column = 0; column < columns; column += 1) tiles.push(tileAt(size, page, column, row));
  return { page, columns, rows, tiles };
}

/** The part of a sheet that is printed on. */
const contentOf = (page: Point): Point => [page[0] - 2 * MARGIN_MM, page[1] - 2 * MARGIN_MM];

function grid(size: Point, page: Point): Pick<PrintPlan, 'page' | 'columns' | 'rows'> {
  const content = contentOf(page);
  const count = (length: number, room: number): number =>
    Math.max(1, Math.ceil((length - OVERLAP_MM) / (room - OVERLAP_MM)));
  return { page, columns: count(size[0], content[0]), rows: count(size[1], content[1]) };
}

function tileAt(size: Point, page: Point, column: number, row: number): Tile {
  const content = contentOf(page);
  const left = column * (content[0] - OVERLAP_MM);
  const top = row * (content[1] - OVERLAP_MM);
  return {
    name: tileName(column, row),
    column,
    row,
    upperLeft: [left, size[1] - top],
    size: [Math.min(content[0], size[0] - left), Math.min(content[1], size[1] - top)],
  };
}

/** A1, B1, … Z1, AA1, … as in a spreadsheet. */
export function tileName(column: number, row: number): string {
  let letters = '';
  for (let rest = column + 1; rest > 0; rest = Math.floor((rest - 1) / 26))
    letters = String.fromCharCode(65 + ((rest - 1) % 26)) + letters;
  return `${letters}${String(row + 1)}`;
}
