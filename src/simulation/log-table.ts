import type { LogEvent } from '#board/data-log';

/** The board's data log as a table. */
export interface LogTable {
  /** Names of the columns so far; the log only ever adds columns at the end. */
  readonly headings: readonly string[];
  /** Oldest first; an early row may have fewer cells than there are columns now. */
  readonly rows: readonly (readonly string[])[];
}

/** An empty log. */
export const emptyLog: LogTable = { headings: [], rows: [] };

/** The table after these events. Copies the rows once, however many events there are. */
export function withLogEvents(table: LogTable, events: readonly LogEvent[]): LogTable {
  let { headings } = table;
  let rows = [...table.rows];
  for (const event of events) {
    switch (event.type) {
      case 'clear':
        headings = [];
        rows = [];
        break;
      case 'row':
        headings = event.headings;
        if (event.values.length > 0) rows.push(event.values); // else headings alone
        break;
      case 'full':
        break;
      default:
        event satisfies never;
    }
  }
  return { headings, rows };
}

/** The table for a spreadsheet: one line per row, cells separated by commas, in quotes where needed (RFC 4180). */
export function csvOf({ headings, rows }: LogTable): string {
  if (headings.length === 0) return '';
  const line = (cells: readonly string[]): string => headings.map((_, i) => quoted(cells[i] ?? '')).join(',');
  return [headings, ...rows].map((cells) => `${line(cells)}\r\n`).join('');
}

const quoted = (cell: string): string => (/[",\r\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
