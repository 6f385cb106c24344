import type { ProbeRow, ProbeTable, Unit } from './table';

/** A row of both tables that is not alike. */
export interface Difference {
  readonly id: string;
  readonly unit: Unit;
  /** `null`: the row is missing there. */
  readonly board: string | null;
  readonly here: string | null;
  /** Excess of the value here over the board's, as a share; `null` for words, and if one is missing or 0. */
  readonly more: number | null;
}

/** One program on the board and here. */
export interface Comparison {
  readonly program: string;
  /** Rows in either. */
  readonly rows: number;
  readonly differences: readonly Difference[];
}

/**
 * Tolerances of a comparison: within this share or this amount, whichever is more. Chosen: a board's clock, its radio and what
 * it does beside the program move times by some per cent; bytes depend on what was imported before.
 */
const ALIKE: Readonly<Record<Exclude<Unit, 'text'>, { readonly share: number; readonly amount: number }>> = {
  us: { share: 0.2, amount: 10 },
  ms: { share: 0.05, amount: 20 },
  bytes: { share: 0.1, amount: 16 },
  items: { share: 0.05, amount: 0 },
  calls: { share: 0.05, amount: 1 },
};

/** Compares two tables of one program, in the order of the board's rows. */
export function compareTables(board: ProbeTable, here: ProbeTable): Comparison {
  const ids = [...new Set([...board.rows.keys(), ...here.rows.keys()])];
  const differences = ids.flatMap((id) => {
    const found = difference(id, board.rows.get(id), here.rows.get(id));
    return found === null ? [] : [found];
  });
  return { program: board.program, rows: ids.length, differences };
}

function difference(id: string, board: ProbeRow | undefined, here: ProbeRow | undefined): Difference | null {
  const unit = board?.unit ?? here?.unit ?? 'text';
  const known = { id, unit, board: board?.value ?? null, here: here?.value ?? null };
  if (board === undefined || here === undefined || board.unit !== here.unit) return { ...known, more: null };
  if (unit === 'text') return board.value === here.value ? null : { ...known, more: null };
  const [one, other] = [Number(board.value), Number(here.value)];
  const { share, amount } = ALIKE[unit];
  if (Math.abs(one - other) <= Math.max(share * Math.abs(one), amount)) return null;
  return { ...known, more: one === 0 ? null : (other - one) / Math.abs(one) };
}
