import type { LogProblem, Remark, Table } from './device-log';
import type { Separated, SeparatedRow } from './separated';
import { isNumber, plainNumber } from './number-in';
import { timeOf } from './time-heading';

/** A table has no more columns: each has a curve of its own. */
const MAX_COLUMNS = 60; // chosen: a micro:bit's log has a handful

/** A table, or the reason why there is none. */
export type ReadTable =
  | { readonly kind: 'table'; readonly table: Table; readonly remarks: readonly Remark[] }
  | { readonly kind: 'problem'; readonly problem: LogProblem };

/**
 * Makes a table of separated values. The first line has the columns' names, unless there is a number in it. A micro:bit
 * writes a new line of names whenever a column is added; some of its programs put an empty line before.
 */
export function readTable({ rows, hasDecimalComma }: Separated): ReadTable {
  const reader = new TableReader(hasDecimalComma);
  let afterGap = true;
  for (const row of rows) {
    const isEmpty = row.cells.every((cell) => cell === '');
    if (!isEmpty) reader.take(row, afterGap);
    afterGap = isEmpty;
    if (reader.columnCount > MAX_COLUMNS) {
      const problem = {
        code: 'too-many-columns',
        line: row.line,
        count: reader.columnCount,
        max: MAX_COLUMNS,
      } as const;
      return { kind: 'problem', problem };
    }
  }
  return reader.result();
}

/** Facts gathered about a column. */
interface Column {
  readonly heading: string;
  numbers: number;
  /** Its cells that are not numbers: the first of them, and their count. */
  texts: number;
  firstText: { readonly line: number; readonly value: string } | null;
}

class TableReader {
  private readonly columns: Column[] = [];
  /** Heading → place in the table. */
  private readonly known = new Map<string, number>();
  private readonly rows: string[][] = [];
  private readonly remarks: Remark[] = [];
  /** Place in the present rows → place in the table. */
  private places: number[] = [];
  /** The names as given in the last line of names. */
  private names: readonly string[] = [];
  private extra: { readonly line: number; readonly value: string; readonly count: number } | null = null;
  private first: { readonly line: number; readonly value: string } | null = null;

  constructor(private readonly hasDecimalComma: boolean) {}

  get columnCount(): number {
    return this.columns.length;
  }

  take(row: SeparatedRow, afterGap: boolean): void {
    this.first ??= { line: row.line, value: row.cells.find((cell) => cell !== '') ?? '' };
    if (this.columns.length === 0) {
      const hasNames = !row.cells.some((cell) => this.isNumber(cell));
      this.setNames(hasNames ? row.cells : row.cells.map((_, place) => `#${String(place + 1)}`), row.line);
      if (hasNames) return;
    } else if (this.isNames(row.cells, afterGap)) {
      this.setNames(row.cells, row.line);
      return;
    } else if (this.isBelowTitle(row.cells)) {
      this.columns.length = 0;
      this.known.clear();
      this.setNames(row.cells, row.line);
      return;
    }
    this.add(row);
  }

  result(): ReadTable {
    const readings = this.columns.filter(({ heading, numbers }) => numbers > 0 && timeOf(heading) === null);
    if (readings.length === 0) {
      const text = this.columns.find(({ firstText }) => firstText !== null)?.firstText ?? this.first;
      return { kind: 'problem', problem: text === null ? { code: 'empty' } : { code: 'no-numbers', ...text } };
    }
    const headings = this.columns.map(({ heading }) => heading);
    return { kind: 'table', table: { headings, rows: this.rows }, remarks: [...this.remarks, ...this.remarksAtEnd()] };
  }

  private isNumber(cell: string): boolean {
    return isNumber(plainNumber(cell, this.hasDecimalComma));
  }

  /** True for names: there is no number among them, and all earlier names are, or a gap is before them. */
  private isNames(cells: readonly string[], afterGap: boolean): boolean {
    if (cells.some((cell) => this.isNumber(cell))) return false;
    const known = this.names.filter((name) => name !== '');
    const isGroup = afterGap && this.rows.length > 0 && cells.length > 1 && cells.every((cell) => cell !== '');
    const all = new Set(cells);
    return isGroup || known.every((name) => all.has(name));
  }

  /** True for names below the title of a table: a line of several cells, without a number, after a single cell. */
  private isBelowTitle(cells: readonly string[]): boolean {
    const isTitle = this.rows.length === 0 && this.columns.length === 1 && cells.length > 1;
    return isTitle && !cells.some((cell) => this.isNumber(cell));
  }

  private setNames(cells: readonly string[], line: number): void {
    const isFirst = this.columns.length === 0;
    const added: string[] = [];
    const seen = new Map<string, number>();
    let length = cells.length;
    while (length > 0 && cells[length - 1] === '') length -= 1;
    this.places = cells.slice(0, length).map((cell, place) => {
      const name = cell === '' ? `#${String(place + 1)}` : cell;
      const times = (seen.get(name) ?? 0) + 1;
      seen.set(name, times);
      const heading = times === 1 ? name : `${name} (${String(times)})`;
      const known = this.known.get(heading);
      if (known !== undefined) return known;
      added.push(heading);
      const own = this.columns.push({ heading, numbers: 0, texts: 0, firstText: null }) - 1;
      this.known.set(heading, own);
      return own;
    });
    this.names = cells;
    if (!isFirst && added.length > 0) this.remarks.push({ code: 'new-columns', line, columns: added.join(', ') });
  }

  private add({ line, cells }: SeparatedRow): void {
    const row = this.columns.map(() => '');
    for (const [place, cell] of cells.entries()) {
      if (cell === '') continue;
      const column = this.places[place];
      const known = column === undefined ? undefined : this.columns[column];
      if (column === undefined || known === undefined) {
        this.extra = { line: this.extra?.line ?? line, value: this.extra?.value ?? cell, count: (this.extra?.count ?? 0) + 1 }; // prettier-ignore
        continue;
      }
      const text = plainNumber(cell, this.hasDecimalComma);
      row[column] = text;
      if (isNumber(text)) known.numbers += 1;
      else {
        known.texts += 1;
        known.firstText ??= { line, value: cell };
      }
    }
    this.rows.push(row);
  }

  private remarksAtEnd(): readonly Remark[] {
    const remarks: Remark[] = [];
    for (const { heading, numbers, texts, firstText } of this.columns)
      if (numbers > 0 && firstText !== null)
        remarks.push({ code: 'not-a-number', ...firstText, column: heading, count: texts });
    const named = this.columns.filter(({ numbers, texts }) => numbers === 0 && texts > 0);
    if (named.length > 0)
      remarks.push({ code: 'text-columns', columns: named.map(({ heading }) => heading).join(', ') });
    if (this.extra !== null) remarks.push({ code: 'extra-cells', ...this.extra });
    return remarks;
  }
}
