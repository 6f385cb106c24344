import type { MicrobitEvent } from './messages';

type RowMessage = Extract<MicrobitEvent, { kind: 'log_output' }>;

/**
 * The columns that the host knows. Its table outlives resets of the board, as the log on the board does: columns of a
 * later program are added at the end.
 */
export class LogColumns {
  private columns: readonly string[] = [];

  /** The host's table is empty. */
  clear(): void {
    this.columns = [];
  }

  /** What the host is told of a row that was logged, its values in the order of `headings`; `null`: nothing. */
  rowMessage(headings: readonly string[], values: readonly string[]): RowMessage | null {
    const added = headings.filter((heading) => !this.columns.includes(heading));
    // A timestamp that comes before anything is logged stands first; the log itself puts it there.
    this.columns = [...this.columns, ...added];
    const cells = new Map(headings.map((heading, index) => [heading, values[index] ?? '']));
    const data = values.length === 0 ? {} : { data: this.columns.map((column) => cells.get(column) ?? '') };
    const news = added.length === 0 ? {} : { headings: [...this.columns] };
    return added.length === 0 && values.length === 0 ? null : { kind: 'log_output', ...news, ...data };
  }
}
