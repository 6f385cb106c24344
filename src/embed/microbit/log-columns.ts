import type { MicrobitEvent } from './messages';

type RowMessage = Extract<MicrobitEvent, { kind: 'log_output' }>;

/**
 * The columns that the host knows. Its table survives resets of the board, as the board's log does: columns of a later
 * program are added at the end.
 */
export class LogColumns {
  private columns: readonly string[] = [];

  /** Forgets the columns: the host's table is empty. */
  clear(): void {
    this.columns = [];
  }

  /** The message for a logged row, its values in the order of `headings`; `null` for nothing. */
  rowMessage(headings: readonly string[], values: readonly string[]): RowMessage | null {
    const added = headings.filter((heading) => !this.columns.includes(heading));
    // A timestamp that is set before anything is logged comes first; the log itself puts it there.
    this.columns = [...this.columns, ...added];
    const cells = new Map(headings.map((heading, index) => [heading, values[index] ?? '']));
    const data = values.length === 0 ? {} : { data: this.columns.map((column) => cells.get(column) ?? '') };
    const news = added.length === 0 ? {} : { headings: [...this.columns] };
    return added.length === 0 && values.length === 0 ? null : { kind: 'log_output', ...news, ...data };
  }
}
