import { tableOf, type Row } from '#lab/tournament/table';

import type { LiveStage } from './tournament-model';

/** A row of the table as it stands, and the places that it has won lately. */
export interface Standing extends Row {
  readonly rise: number;
}

/**
 * The table of a stage as it stands. A rise counts against the table as it was as many matches ago as there are programs: each has
 * played about twice since then.
 */
export function standingOf({ names, matches, ended, of, mode, reached }: Shown): readonly Standing[] {
  const now = tableOf(names, matches, reached);
  const earlier = ended.length - names.length;
  if (earlier <= 0 || ended.length === of || mode === 'knockout') return now.map((row) => ({ ...row, rise: 0 }));
  const before = tableOf(names, ended.slice(0, earlier)).map(({ name }) => name);
  return now.map((row, place) => ({ ...row, rise: Math.max(0, before.indexOf(row.name) - place) }));
}

type Shown = Pick<LiveStage, 'names' | 'matches' | 'ended' | 'of' | 'mode'> & {
  /** How far each has come in a knockout; left out: a league. */
  readonly reached?: readonly number[];
};
