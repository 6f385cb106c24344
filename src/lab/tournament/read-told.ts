import { isRecord } from '#core/record';
import type { Reader } from '#scene/reader';
import { tournamentLimits } from './limits';
import type { Match } from './match';
import type { Row } from './table';

/** A match or a row of a table as a file tells it: what it must have is not sure, but nothing in it is deep. */
export type Told = Readonly<Record<string, string | number | boolean | null>>;

/** The part of a stage that a file tells and that is compared. */
export interface ToldStage {
  readonly matches: readonly Told[];
  readonly table: readonly Told[];
}

const MATCH: readonly (keyof Match)[] = ['a', 'b', 'seed', 'winner', 'atMs', 'reason', 'traceHash'];
const ROW: readonly (keyof Row)[] = ['name', 'points', 'won', 'drawn', 'lost', 'passed'];

/** Reads what a file tells of a stage. Unknown fields are left out, and what is no plain value is `null`. */
export function readToldStage(value: unknown, path: string, reader: Reader): ToldStage {
  if (!isRecord(value)) reader.wrongType(value, path, 'an object { … }');
  const { matches, table } = isRecord(value) ? value : {};
  return {
    matches: readAll(matches, `${path}.matches`, { known: MATCH, max: tournamentLimits.matches }, reader),
    table: readAll(table, `${path}.table`, { known: ROW, max: tournamentLimits.programs.max }, reader),
  };
}

function readAll(
  value: unknown,
  path: string,
  { known, max }: { readonly known: readonly string[]; readonly max: number },
  reader: Reader,
): readonly Told[] {
  return reader.list(value, path, { min: 0, max }).map((one, place): Told => {
    if (!isRecord(one)) {
      reader.wrongType(one, `${path}[${place}]`, 'an object { … }');
      return {};
    }
    const kept = known.filter((key) => Object.hasOwn(one, key)).map((key) => [key, plain(one[key])] as const);
    return Object.fromEntries(kept);
  });
}

const plain = (value: unknown): Told[string] =>
  typeof value === 'string' || typeof value === 'number' || typeof value === 'boolean' ? value : null;
