/** A row of a text of separated values: its cells, and the line at which it begins, from 1. */
export interface SeparatedRow {
  readonly line: number;
  readonly cells: readonly string[];
}

/** A text of separated values. */
export interface Separated {
  readonly rows: readonly SeparatedRow[];
  /** True if numbers may have a decimal comma: it separates no values. */
  readonly hasDecimalComma: boolean;
}

/** In this order where several fit equally well: a comma may also be a decimal comma. */
const SEPARATORS = ['\t', ';', ','] as const;
/** Number of lines that decide on the separator. */
const LINES_LOOKED_AT = 20;
/** A line of a one-column table, if its first line has no comma. */
const DECIMAL_COMMA_ALONE = /^[+-]?\d+,\d+$/;

/** Splits a text into cells: separated by commas, semicolons or tabs, in quotes where needed (RFC 4180). */
export function separated(text: string): Separated {
  // Excel's own word for the separator, as a first line.
  const told = /^sep=(.)\r?\n/.exec(text);
  const rest = told === null ? text : text.slice(told[0].length);
  const separator = told?.[1] ?? separatorOf(rest);
  return { rows: rowsOf(rest, separator, told === null ? 1 : 2), hasDecimalComma: separator !== ',' };
}

/**
 * The character that occurs equally often in most lines, as the first may be a title. Without one: a character that
 * never occurs.
 */
function separatorOf(text: string): string {
  const all = linesAtBegin(text);
  const lines = all[0]?.includes(',') === true ? all : all.filter((line) => !DECIMAL_COMMA_ALONE.test(line));
  let best: string = ';';
  let most = 0;
  for (const sign of SEPARATORS) {
    const alike = mostAlike(lines.map((line) => line.replaceAll(/"[^"]*"/g, '').split(sign).length - 1));
    if (alike <= most) continue;
    best = sign;
    most = alike;
  }
  return best;
}

/** Number of lines in which the character occurs equally often. */
function mostAlike(counts: readonly number[]): number {
  const lines = new Map<number, number>();
  for (const count of counts) if (count > 0) lines.set(count, (lines.get(count) ?? 0) + 1);
  return Math.max(0, ...lines.values());
}

function linesAtBegin(text: string): readonly string[] {
  const lines: string[] = [];
  for (let at = 0; at < text.length && lines.length < LINES_LOOKED_AT;) {
    const end = text.indexOf('\n', at);
    const line = text.slice(at, end === -1 ? text.length : end).trimEnd();
    if (line !== '') lines.push(line);
    at = end === -1 ? text.length : end + 1;
  }
  return lines;
}

function rowsOf(text: string, separator: string, firstLine: number): readonly SeparatedRow[] {
  const rows: SeparatedRow[] = [];
  let line = firstLine;
  let at = 0;
  while (at < text.length) {
    const cells: string[] = [];
    const began = line;
    for (let isRow = true; isRow;) {
      const cell = cellAt(text, at, separator);
      cells.push(cell.text.trim());
      line += cell.lineEnds;
      at = cell.end + 1;
      isRow = text[cell.end] === separator;
    }
    if (text[at - 1] === '\r' && text[at] === '\n') at += 1;
    line += 1;
    rows.push({ line: began, cells });
  }
  return rows;
}

/** A cell, where it ends (at a separator, a line's end, or the text's), and how many line ends its quotes hold. */
function cellAt(text: string, from: number, separator: string): { text: string; end: number; lineEnds: number } {
  let end = from;
  let close = -1;
  if (text[from] === '"') {
    close = text.indexOf('"', from + 1);
    while (close !== -1 && text[close + 1] === '"') close = text.indexOf('"', close + 2);
    end = close + 1;
  }
  if (close === -1) end = from; // also a quote that never ends: else it would take the rest of the file
  while (end < text.length && text[end] !== separator && text[end] !== '\n' && text[end] !== '\r') end += 1;
  if (close === -1) return { text: text.slice(from, end), end, lineEnds: 0 };
  const inside = text.slice(from + 1, close);
  return {
    text: inside.replaceAll('""', '"') + text.slice(close + 1, end),
    end,
    lineEnds: inside.split('\n').length - 1,
  };
}
