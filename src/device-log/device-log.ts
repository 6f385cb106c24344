/** A table of texts: what the simulated board's log is, too. */
export interface Table {
  readonly headings: readonly string[];
  /** Oldest first; a row may have fewer cells than there are columns. Numbers have a decimal point. */
  readonly rows: readonly (readonly string[])[];
}

/** The data that a real board has logged, from a file. */
export interface DeviceLog extends Table {
  /** The board's memory was full: later rows are missing. */
  readonly isFull: boolean;
  /** Remarks on the file for the reader of the curves. */
  readonly remarks: readonly Remark[];
}

/** Something in a file that can be read in spite of it. Lines count from 1. */
export type Remark =
  /** The file ends before its log does: a last, broken row is left out. */
  | { readonly code: 'cut-off'; readonly rows: number }
  /** Cells that are not numbers in a column of numbers: the first, and their count. */
  | { readonly code: 'not-a-number'; readonly line: number; readonly column: string; readonly value: string; readonly count: number } // prettier-ignore
  /** Cells to the right of the last column: the first, and how many there are. */
  | { readonly code: 'extra-cells'; readonly line: number; readonly value: string; readonly count: number }
  /** From this line on the log has other columns. */
  | { readonly code: 'new-columns'; readonly line: number; readonly columns: string }
  /** Columns without any number: they have no curve. */
  | { readonly code: 'text-columns'; readonly columns: string };

/** Why a file has no log to show. Sizes in kB. */
export type LogProblem =
  | { readonly code: 'empty' }
  | { readonly code: 'workbook' }
  | { readonly code: 'not-text' }
  /** A page that is not from a micro:bit. */
  | { readonly code: 'other-page' }
  /** A micro:bit's page that ends before its data begins. */
  | { readonly code: 'cut-short'; readonly size: number; readonly start: number }
  /** A micro:bit's page without a row. */
  | { readonly code: 'empty-log' }
  | { readonly code: 'too-many-columns'; readonly line: number; readonly count: number; readonly max: number }
  | { readonly code: 'no-numbers'; readonly line: number; readonly value: string };

/** Result of reading a file. */
export type ReadLog =
  { readonly kind: 'log'; readonly log: DeviceLog } | { readonly kind: 'problem'; readonly problem: LogProblem };
