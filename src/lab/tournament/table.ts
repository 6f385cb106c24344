import type { Match } from './match';

/** A row of the table. */
export interface Row {
  readonly name: string;
  readonly points: number;
  readonly won: number;
  readonly drawn: number;
  readonly lost: number;
  /** Runs in which it has passed; only in a course for one robot. */
  readonly passed?: number;
}

const [WIN, DRAW] = [3, 1];

/** The matches of one program, counted. */
export interface Score {
  readonly won: number;
  readonly drawn: number;
  readonly lost: number;
  /** Simulated time of its wins together. */
  readonly wonMs: number;
}

/** The score of the program at a place. */
export function scoreOf(place: number, matches: readonly Match[]): Score {
  let [won, drawn, lost, wonMs] = [0, 0, 0, 0];
  for (const { a, b, winner, atMs } of matches) {
    if (a !== place && b !== place) continue;
    const winning = winner === 'a' ? a : b;
    if (winner === 'draw') drawn += 1;
    else if (winning !== place) lost += 1;
    else {
      won += 1;
      wonMs += atMs ?? 0;
    }
  }
  return { won, drawn, lost, wonMs };
}

/**
 * The table: by points, then by wins, then by the time of all wins together, then in the order of the programs.
 *
 * @param reached how far each has come in a knockout, which decides first; left out: a league
 */
export function tableOf(
  names: readonly string[],
  matches: readonly Match[],
  reached?: readonly number[],
): readonly Row[] {
  const isAlone = matches.some(({ b }) => b === null);
  return names
    .map((name, place) => {
      const { won, drawn, lost, wonMs } = scoreOf(place, matches);
      const row: Row = { name, points: WIN * won + DRAW * drawn, won, drawn, lost, ...(isAlone && { passed: won }) };
      return { row, wonMs, reached: reached?.[place] ?? 0 };
    })
    .sort(
      (one, other) =>
        other.reached - one.reached ||
        other.row.points - one.row.points ||
        other.row.won - one.row.won ||
        one.wonMs - other.wonMs,
    )
    .map(({ row }) => row);
}
