import type { Language } from './languages';
import { plainText } from './unseen';

/** A cell of a table: a text, a number, or nothing. */
export type Cell = string | number | null;

/** A table as CSV for programs: commas, numbers with a point; RFC 4180. */
export const csvText = (rows: readonly (readonly Cell[])[]): string => tableText(rows, { sign: ',', point: '.' });

/** The signs of a spreadsheet's files. */
export interface SpreadsheetForm {
  /** Between cells. */
  readonly sign: ',' | ';';
  /** Between a number's whole part and its decimals. */
  readonly point: '.' | ',';
}

/** The signs that spreadsheets expect in a language where decimals have this sign: it never parts cells, too. */
export const formWith = (language: Language, point: SpreadsheetForm['point']): SpreadsheetForm => ({
  sign: point === ',' || language !== 'en' ? ';' : ',',
  point,
});

/**
 * The signs that spreadsheets expect in a language: in German, French and Italian semicolons and decimal commas. In
 * Switzerland decimals have a point: whoever knows the country says so.
 */
export const usualForm = (language: Language): SpreadsheetForm => formWith(language, language === 'en' ? '.' : ',');

/** A table as CSV for a spreadsheet: opened by a double click, each cell is in its column, and a number is a number. */
export const spreadsheetText = (rows: readonly (readonly Cell[])[], form: SpreadsheetForm): string =>
  // Spreadsheets take a file for UTF-8 only if it begins with this sign.
  `\ufeff${tableText(rows, form)}`;

const tableText = (rows: readonly (readonly Cell[])[], form: SpreadsheetForm): string =>
  rows.map((cells) => `${cells.map((one) => cellText(one, form)).join(form.sign)}\r\n`).join('');

/**
 * Defuses a text that a spreadsheet would take for a formula: also behind a sign that parts cells on computers of
 * other languages, or a line break.
 */
function cellText(cell: Cell, { point }: SpreadsheetForm): string {
  if (cell === null) return '';
  if (typeof cell === 'number') return String(cell).replace('.', point);
  const isNumber = /^-?\d+(\.\d+)?$/.test(cell);
  const safe = isNumber ? cell : plainText(cell).replace(FORMULA, "$1'$2");
  return /[";,\t\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

/** Beginning of a cell that makes it a formula; some spreadsheets leave out spaces and quotes before it. */
const FORMULA = /(^|[;\t\r\n])((?:[^\S\t\r\n]|")*[=+\-@\uff1d\uff0b\uff0d\uff20])/g;
